/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "watch.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "../io/file.h"
#include "../io/system.h"

#define TELL_SECONDS 20

/* A signal handler sees nothing but what lies still. */
static const char *command;
static volatile sig_atomic_t passed, limit;

/* write() and no stdio: the program may be anywhere. */
static void say(const char *text)
{
    size_t length = strlen(text);
    while (length > 0) {
        const ssize_t written = write(STDERR_FILENO, text, length);
        if (written <= 0) {
            return;
        }
        text += written;
        length -= (size_t)written;
    }
}

static void say_number(long number)
{
    char digits[24];
    char *first = digits + sizeof digits - 1;
    *first = '\0';
    do {
        *--first = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    say(first);
}

static unsigned next_pause(void)
{
    const long left = limit - passed;
    return limit != 0 && left < TELL_SECONDS ? (unsigned)(left > 0 ? left : 1) : TELL_SECONDS;
}

static void report(int number)
{
    (void)number;
    say("qtri ");
    say(command);
    if (limit != 0 && passed >= limit) {
        file_remove_unfinished();
        say(": not done after ");
        say_number(passed);
        say(" seconds (qtri --seconds N ...)\n");
        _exit(1);
    }
    say(": at work for ");
    say_number(passed);
    say(" seconds\n");
    const unsigned pause = next_pause();
    passed += (sig_atomic_t)pause;
    system_alarm(pause, report);
}

void watch_begin(const char *name, long seconds)
{
    command = name;
    limit = (sig_atomic_t)seconds;
    passed = 0;
    passed = (sig_atomic_t)next_pause();
    system_alarm((unsigned)passed, report);
}
