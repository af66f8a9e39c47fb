/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "asset_header.h"

#include <stdlib.h>
#include <string.h>

#include "../io/file.h"

static void set_capitals(struct asset_names *names)
{
    size_t i = 0;
    for (const char *at = names->name; *at != '\0' && i + 1 < sizeof names->capitals; at++, i++) {
        names->capitals[i] = (char)(*at >= 'a' && *at <= 'z' ? *at - 'a' + 'A' : *at);
    }
    names->capitals[i] = '\0';
}

void asset_header_write(const struct asset_header *kind, const void *thing, const char *name,
                        const char *header_name, FILE *header, FILE *source)
{
    struct asset_names names = {.name = name, .linkage = source == NULL ? "static " : ""};
    set_capitals(&names);
    kind->summary(header, thing, &names);
    fprintf(header,
            "#ifndef %s_%s_H\n#define %s_%s_H\n\n#include <qtri.h>\n#include <stddef.h>\n\n",
            names.capitals, kind->guard, names.capitals, kind->guard);
    if (kind->sizes != NULL) {
        kind->sizes(header, thing, &names);
    }
    if (source != NULL) {
        fputs("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n", header);
        kind->declarations(header, thing, &names);
        fputs("\n#ifdef __cplusplus\n}\n#endif\n", header);
        fprintf(source, "#include \"%s\"\n\n", header_name);
    }
    kind->data(source != NULL ? source : header, thing, &names);
    fputs("\n#endif\n", header);
}

/* NAME.c beside NAME.h. */
static bool open_source(struct file_output *output, const char *path, struct text_error *error)
{
    char *source = strdup(path);
    if (source == NULL) {
        return text_error_set(error, path, 0, "out of memory");
    }
    source[strlen(source) - 1] = 'c';
    const bool ok = file_output_open(output, source, error);
    free(source);
    return ok;
}

bool asset_header_save(const struct asset_header *kind, const void *thing, const char *name,
                       const char *path, bool split, struct text_error *error)
{
    struct file_output header, source = {.stream = NULL};
    const char *slash = strrchr(path, '/');
    if (!file_output_open(&header, path, error)) {
        return false;
    }
    bool ok = !split || open_source(&source, path, error);
    if (ok) {
        asset_header_write(kind, thing, name, slash != NULL ? slash + 1 : path, header.stream,
                           source.stream);
        ok = !split || file_output_commit(&source, error);
    }
    if (!ok) {
        file_output_cancel(&header);
        return false;
    }
    return file_output_commit(&header, error);
}
