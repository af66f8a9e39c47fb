/* SPDX-License-Identifier: MIT */
/*
 * What keeps a command from being silent, or at work, for ever: a small file can ask for very much.
 */
#ifndef QTRI_HOST_TOOLS_WATCH_H
#define QTRI_HOST_TOOLS_WATCH_H

#define WATCH_SECONDS 300 /* a command may take, where nothing else is asked for */

/*
 * From now on standard error gets a line every 20 seconds, and after `seconds` the program ends
 * with a message and status 1, and no output file is left behind that is not complete. 0: it may
 * take as long as it takes. `name` is the command's and must stay.
 */
void watch_begin(const char *name, long seconds);

#endif
