/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "system.h"

#ifndef _WIN32

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void system_begin(int argc, char **argv)
{
    (void)argc;
    (void)argv;
}

int system_open_input(const char *path)
{
    return open(path, O_RDONLY | O_NONBLOCK);
}

int system_await_input(int descriptor, int seconds)
{
    struct pollfd input = {descriptor, POLLIN, 0};
    int ready = 0;
    do {
        ready = poll(&input, 1, seconds * 1000);
    } while (ready < 0 && errno == EINTR);
    return ready > 0 ? 0 : (ready == 0 ? ETIMEDOUT : errno);
}

/* The user's umask applies. */
int system_create(const char *path)
{
    return open(path, O_CREAT | O_EXCL | O_WRONLY, 0666);
}

int system_replace(const char *from, const char *to)
{
    return rename(from, to) == 0 ? 0 : errno;
}

char *system_real_path(const char *path)
{
    return realpath(path, NULL);
}

int system_make_folder(const char *path)
{
    return mkdir(path, 0777) == 0 ? 0 : errno;
}

bool system_program(char *path, size_t size)
{
    const ssize_t length = readlink("/proc/self/exe", path, size - 1);
    path[length > 0 ? length : 0] = '\0';
    return length > 0;
}

/* Signals that are ignored stay ignored, as nohup wants it. */
void system_on_end(void (*end)(int number))
{
    static const int numbers[] = {SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU, SIGXFSZ};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        struct sigaction action;
        if (sigaction(numbers[i], NULL, &action) == 0 && action.sa_handler == SIG_DFL) {
            action.sa_handler = end;
            (void)sigaction(numbers[i], &action, NULL);
        }
    }
}

/* signal() of strict C99 would hold for one signal only. */
static void handle(int number, void (*handler)(int number))
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    (void)sigemptyset(&action.sa_mask);
    (void)sigaction(number, &action, NULL);
}

void system_on_interrupt(void (*stop)(int number))
{
    handle(SIGINT, stop);
}

void system_alarm(unsigned seconds, void (*ring)(int number))
{
    handle(SIGALRM, ring);
    (void)alarm(seconds);
}

#endif
