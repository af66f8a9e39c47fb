/* SPDX-License-Identifier: MIT */
/*
 * Where the instructions of one draw call go: profile TABLE COUNTS < LOG
 *
 * LOG is what `qemu-system-arm -d in_asm,exec,nochain` writes: the addresses of every translation
 * block, once, and a line for each execution of one. TABLE has a line
 * `address stage symbol file function` (address in hexadecimal) for every instruction of the
 * program: the symbol it lies in, and the function of the source it comes from, which may be
 * inlined. A stage `-` means that of whoever called: helpers of arithmetic and memory.
 *
 * COUNTS gets a line `address count` for every instruction that was executed. Counted is what runs
 * from the first instruction of bench_draw to the next of board_ticks.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE_MAX_BYTES  1024
#define NAME_MAX_BYTES  160
#define CODE_MAX_BYTES  (4u << 20)
#define NAMES_MAX       4096
#define STAGES_MAX      16
#define BLOCKS_LOG2     16
#define BLOCK_MAX_WORDS 1024
#define SHOWN           25

static void fail(const char *message)
{
    fprintf(stderr, "profile: %s\n", message);
    exit(1);
}

/* Names, each once; a few hundred. */
struct name {
    char text[NAME_MAX_BYTES];
    uint64_t instructions;
    uint64_t calls;
};
struct names {
    struct name *name;
    int count, max;
};

static int name_index(struct names *names, const char *text)
{
    for (int i = 0; i < names->count; i++) {
        if (strcmp(names->name[i].text, text) == 0) {
            return i;
        }
    }
    if (names->count == names->max) {
        fail("too many names");
    }
    snprintf(names->name[names->count].text, NAME_MAX_BYTES, "%s", text);
    return names->count++;
}

/* An instruction of the program. */
struct instruction {
    uint64_t count;
    int16_t stage, symbol, function;
    bool known, begins_symbol;
};

/* A translation block: the same address may be translated with several flags. */
struct block {
    uint64_t key; /* 0: free */
    int count;
    uint32_t *address;
};

static struct {
    struct names stages, symbols, functions;
    struct instruction *code; /* by address / 2 */
    uint32_t base;            /* of the code */
    uint32_t draw, ticks;     /* addresses of bench_draw and board_ticks */
    struct block *blocks;
    int16_t helpers; /* the stage `-` */
} profile;

static struct instruction *instruction_at(uint32_t address)
{
    uint32_t offset = address - profile.base;
    return offset < CODE_MAX_BYTES ? &profile.code[offset / 2] : NULL;
}

static void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (memory == NULL) {
        fail("out of memory");
    }
    return memory;
}

static void names_create(struct names *names, int max)
{
    names->name = allocate((size_t)max, sizeof *names->name);
    names->count = 0;
    names->max = max;
}

static void read_table(const char *path)
{
    FILE *table = fopen(path, "r");
    char line[LINE_MAX_BYTES];
    if (table == NULL) {
        fail("the table cannot be read");
    }
    names_create(&profile.stages, STAGES_MAX);
    names_create(&profile.symbols, NAMES_MAX);
    names_create(&profile.functions, NAMES_MAX);
    profile.code = allocate(CODE_MAX_BYTES / 2, sizeof *profile.code);
    profile.helpers = (int16_t)name_index(&profile.stages, "-");
    int last_symbol = -1;
    while (fgets(line, sizeof line, table) != NULL) {
        char stage[32], symbol[64], file[80], function[64], text[NAME_MAX_BYTES];
        unsigned address = 0;
        if (sscanf(line, "%x %31s %63s %79s %63s", &address, stage, symbol, file, function) != 5) {
            fail("a line of the table is not understood");
        }
        profile.base = last_symbol < 0 ? address & ~(CODE_MAX_BYTES - 1) : profile.base;
        struct instruction *at = instruction_at(address);
        if (at == NULL) {
            fail("the code is too long");
        }
        snprintf(text, sizeof text, "%s\t%s", symbol, file);
        at->known = true;
        at->stage = (int16_t)name_index(&profile.stages, stage);
        at->symbol = (int16_t)name_index(&profile.symbols, text);
        snprintf(text, sizeof text, "%s\t%s", function, file);
        at->function = (int16_t)name_index(&profile.functions, text);
        at->begins_symbol = at->symbol != last_symbol;
        last_symbol = at->symbol;
        if (at->begins_symbol && strcmp(symbol, "bench_draw") == 0) {
            profile.draw = address;
        }
        if (at->begins_symbol && strcmp(symbol, "board_ticks") == 0) {
            profile.ticks = address;
        }
    }
    fclose(table);
    if (profile.draw == 0 || profile.ticks == 0) {
        fail("the program has no bench_draw or no board_ticks");
    }
}

static struct block *block_of(uint64_t key)
{
    size_t mask = ((size_t)1 << BLOCKS_LOG2) - 1;
    size_t at = (size_t)((key * UINT64_C(0x9E3779B97F4A7C15)) >> (64 - BLOCKS_LOG2));
    for (size_t tries = 0; tries <= mask; tries++, at = (at + 1) & mask) {
        if (profile.blocks[at].key == 0 || profile.blocks[at].key == key) {
            return &profile.blocks[at];
        }
    }
    fail("too many translation blocks");
    return NULL;
}

/* Adds (or, sign -1, takes back) one execution. Returns the stage that it leaves behind. */
static int16_t count_block(const struct block *block, int16_t stage, int sign)
{
    for (int i = 0; i < block->count; i++) {
        struct instruction *at = instruction_at(block->address[i]);
        if (at == NULL || !at->known) {
            fail("an instruction was executed that the table does not know");
        }
        at->count += (uint64_t)(int64_t)sign;
        stage = at->stage == profile.helpers ? stage : at->stage;
        profile.stages.name[stage].instructions += (uint64_t)(int64_t)sign;
        profile.symbols.name[at->symbol].instructions += (uint64_t)(int64_t)sign;
        profile.functions.name[at->function].instructions += (uint64_t)(int64_t)sign;
        profile.symbols.name[at->symbol].calls +=
            i == 0 && at->begins_symbol ? (uint64_t)(int64_t)sign : 0;
    }
    return stage;
}

static void remember(struct block *block, uint64_t key, const uint32_t *address, int count)
{
    free(block->address);
    block->key = key;
    block->count = count;
    block->address = allocate((size_t)count, sizeof *address);
    memcpy(block->address, address, (size_t)count * sizeof *address);
}

/* `... [flags/pc/flags/cflags] symbol`: the block's address, and the key of this translation. */
static bool parse_trace(const char *line, uint32_t *pc, uint64_t *key)
{
    const char *bracket = strchr(line, '[');
    char *end = NULL;
    if (bracket == NULL || (bracket = strchr(bracket, '/')) == NULL) {
        return false;
    }
    *pc = (uint32_t)strtoul(bracket + 1, &end, 16);
    if (*end != '/' || (end = strchr(end + 1, '/')) == NULL) {
        return false;
    }
    *key = (uint64_t)*pc << 32 | strtoul(end + 1, NULL, 16);
    return true;
}

static void read_log(FILE *log)
{
    char line[LINE_MAX_BYTES];
    static uint32_t translated[BLOCK_MAX_WORDS];
    int translated_count = 0;
    bool counting = false;
    const struct block *last = NULL;
    int16_t stage = profile.helpers;
    int16_t stage_before = stage;
    profile.blocks = allocate((size_t)1 << BLOCKS_LOG2, sizeof *profile.blocks);
    while (fgets(line, sizeof line, log) != NULL) {
        if (line[0] == '0' && line[1] == 'x') {
            if (translated_count == BLOCK_MAX_WORDS) {
                fail("a translation block is too long");
            }
            translated[translated_count++] = (uint32_t)strtoul(line, NULL, 16);
        } else if (strncmp(line, "IN:", 3) == 0) {
            translated_count = 0;
        } else if (strncmp(line, "Trace", 5) == 0) {
            uint32_t pc = 0;
            uint64_t key = 0;
            if (!parse_trace(line, &pc, &key)) {
                fail("a line of the log is not understood");
            }
            struct block *block = block_of(key);
            if (translated_count > 0 && translated[0] == pc) {
                remember(block, key, translated, translated_count);
                translated_count = 0;
            }
            counting = pc == profile.draw || (counting && pc != profile.ticks);
            if (pc == profile.ticks && last != NULL) {
                return;
            }
            if (counting) {
                if (block->key == 0) {
                    fail("a block was executed that was not translated");
                }
                stage_before = stage;
                stage = count_block(block, stage, 1);
                last = block;
            }
        } else if (counting && last != NULL && strncmp(line, "Stopped", 7) == 0) {
            count_block(last, stage_before, -1); /* it will run later */
            stage = stage_before;
        }
    }
    fail("the log ends before bench_draw does");
}

static int by_instructions(const void *a, const void *b)
{
    uint64_t x = ((const struct name *)a)->instructions;
    uint64_t y = ((const struct name *)b)->instructions;
    return (x < y) - (x > y);
}

static void print_names(struct names *names, const char *title, uint64_t total, bool with_calls)
{
    qsort(names->name, (size_t)names->count, sizeof names->name[0], by_instructions);
    printf("\n%12s%8s", "instructions", "%");
    if (with_calls) {
        printf("%10s%10s", "calls", "per call");
    }
    printf("  %s\n", title);
    for (int i = 0; i < names->count && i < SHOWN && names->name[i].instructions > 0; i++) {
        const struct name *name = &names->name[i];
        const char *tab = strchr(name->text, '\t');
        int width = tab == NULL ? (int)strlen(name->text) : (int)(tab - name->text);
        printf("%12llu%8.1f", (unsigned long long)name->instructions,
               100.0 * (double)name->instructions / (double)total);
        if (with_calls) {
            double calls = (double)name->calls;
            printf("%10llu%10.1f", (unsigned long long)name->calls,
                   calls > 0.0 ? (double)name->instructions / calls : 0.0);
        }
        printf("  %-*.*s %s\n", tab == NULL ? 0 : 36, width, name->text,
               tab == NULL ? "" : tab + 1);
    }
}

static void write_counts(const char *path)
{
    FILE *out = fopen(path, "w");
    if (out == NULL) {
        fail("the counts cannot be written");
    }
    for (uint32_t i = 0; i < CODE_MAX_BYTES / 2; i++) {
        if (profile.code[i].count > 0) {
            fprintf(out, "%x %llu\n", (unsigned)(profile.base + 2 * i),
                    (unsigned long long)profile.code[i].count);
        }
    }
    fclose(out);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: profile TABLE COUNTS < LOG\n");
        return 2;
    }
    read_table(argv[1]);
    read_log(stdin);
    write_counts(argv[2]);
    uint64_t total = 0;
    for (int i = 0; i < profile.stages.count; i++) {
        total += profile.stages.name[i].instructions;
    }
    printf("%llu instructions\n", (unsigned long long)total);
    print_names(&profile.stages, "stage", total, false);
    print_names(&profile.symbols, "function, with what is inlined in it", total, true);
    print_names(&profile.functions, "function of the source, inlined or not", total, false);
    return 0;
}
