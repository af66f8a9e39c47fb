# SPDX-License-Identifier: MIT
# Prints C: COUNT pipelines, random but for seven, and some that are seldom asked for, a part of them a file (pipelines
# are slow to compile), and their list.
#   awk -v seed=7 -v count=240 -v part=0 -v parts=12 -f random_pipelines.awk      one file of pipelines
#   awk -v seed=7 -v count=240 -v list=1 -f random_pipelines.awk                  the list
function below(n) { state = (state * 16807) % 2147483647; return int(state / 2147483647 * n) }
function one_of(words,    w, n) { n = split(words, w, " "); return w[1 + below(n)] }
# Every second one is plain: shaded and stored, with 16 bits of depth or none, as the loops of the generic pipeline ask;
# half of these have one option more.
function one_more(texel)
{
    if (texel == "-") return one_of(",~.keep~=~1 ,~.fog~=~1 ,~.fragment~=~random_fragment ,~.blend~=~QTRI_ALPHA,~.vertex_alpha~=~1")
    if (texel ~ /^A/ && below(2) == 0) return ",~.alpha_test~=~1"
    return one_of(",~.bilinear~=~1 ,~.large_texture~=~1 ,~.keep~=~1 ,~.fog~=~1 ,~.fragment~=~random_fragment")
}
function options(i,    format, texel, text)
{
    if (i in fixed) return ".compare = QTRI_LESS, .depth = QTRI_" (i == 6 ? "LINEAR24, " : "LINEAR16, ") fixed[i]
    plain = i % 2
    format = one_of("RGB565 RGB565 RGB565 RGB565_SWAPPED RGB565_EXACT RGB888 BGR888 XRGB8888 XRGB8888 GRAY8 DEPTH_ONLY")
    texel = one_of("- - - RGB565 RGB565 RGB565 XRGB8888 GRAY8 PALETTE8 PALETTE565 CHECKER ARGB8888 ARGB4444 ARGB1555 ALPHA8")
    text = ".format = QTRI_" format
    samples = !plain && format !~ /EXACT|BGR|ONLY/ && below(2) == 0
    if (samples) text = text ", .samples = 4"
    depth = samples || plain ? one_of("NO_DEPTH LINEAR16 LINEAR16 LINEAR16 LINEAR16") : one_of("NO_DEPTH LINEAR16 LINEAR16 LINEAR16 FLOAT16 LINEAR24 LINEAR32")
    if (depth != "NO_DEPTH") {
        text = text ", .depth = QTRI_" depth ", .compare = QTRI_" one_of("ANY ANY LESS LESS LESS LESS_EQUAL GREATER GREATER_EQUAL EQUAL NOT_EQUAL ALWAYS")
        text = text ", .read_only = " one_of("0 0 0 1 QTRI_ANY")
    }
    if (texel == "-") {
        shade = one_of("FLAT LIGHT COLORS")
    } else {
        shade = one_of("FLAT TINT LIGHT WHITE_LIGHT COLORS")
        text = text ", .texel = QTRI_TEXEL_" texel
        if (below(3) == 0 && !plain) text = text ", .bilinear = 1"
        if (below(3) == 0 && !samples) text = text ", .mipmapped = 1"
        if (below(3) == 0) text = text ", .wrap_u = QTRI_CLAMP"
        if (below(3) == 0) text = text ", .wrap_v = QTRI_CLAMP"
        if (below(4) == 0) text = text ", .key = 1"
        if (texel ~ /^A/ && below(2) == 0 && !plain) text = text ", .alpha_test = 1"
        if (below(8) == 0 && !plain) text = text ", .large_texture = 1"
    }
    text = text ", .shade = QTRI_" shade
    if (shade == "COLORS" && below(3) == 0) text = text ", .per_pixel = 1"
    if (plain && i % 4 == 1) return text
    if (plain) {
        more = one_more(texel)
        gsub(/~/, " ", more)
        return text more
    }
    blend = one_of("STORE STORE STORE ALPHA ADD MULTIPLY KEEP_PIXEL SCREEN_DOOR")
    text = text ", .blend = QTRI_" blend
    if (blend ~ /ALPHA|ADD/ && below(3) == 0) { text = text ", .vertex_alpha = 1"; varies = 1 } else varies = 0
    if (blend ~ /STORE|ALPHA|ADD|MULTIPLY/ && format != "GRAY8" && below(6) == 0) text = text ", .keep = 1"
    if (below(4) == 0) text = text ", .fog = 1"
    if (below(8) == 0) text = text ", .fragment = random_fragment"
    return text
}
BEGIN {
    fixed[0] = ".format = QTRI_XRGB8888, .texel = QTRI_TEXEL_ARGB8888"
    fixed[1] = ".format = QTRI_RGB565, .texel = QTRI_TEXEL_RGB565, .key = 1, .shade = QTRI_LIGHT"
    fixed[2] = ".format = QTRI_RGB888, .shade = QTRI_COLORS"
    fixed[3] = ".format = QTRI_GRAY8, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_COLORS"
    fixed[4] = ".format = QTRI_RGB565, .shade = QTRI_COLORS"
    fixed[5] = ".format = QTRI_RGB565_SWAPPED"
    fixed[6] = ".format = QTRI_RGB888, .shade = QTRI_LIGHT"
    less = ".depth = QTRI_LINEAR16, .compare = QTRI_LESS"
    own = ".format = QTRI_OTHER_FORMAT, .own_format = &random_format, .pixel_bytes = 2, "
    mine = ".texel = QTRI_OTHER_TEXEL, .own_texel = &random_texels, "
    rare[0] = ".format = QTRI_GRAY8, .fragment = random_fragment"
    rare[1] = ".format = QTRI_RGB565, .samples = 4, .fragment = random_fragment, " less
    rare[2] = ".format = QTRI_RGB565, .samples = 4, " less
    rare[3] = ".format = QTRI_RGB565, .shade = QTRI_COLORS, .per_pixel = 1, " less
    rare[4] = ".format = QTRI_RGB565, .read_only = 1, " less
    rare[5] = ".format = QTRI_RGB565, .fog = 1, " less
    rare[6] = ".format = QTRI_RGB565, .blend = QTRI_KEEP_PIXEL, .fragment = random_fragment, " less
    rare[7] = ".format = QTRI_RGB565, .texel = QTRI_TEXEL_ARGB4444, .alpha_test = 1, " less
    rare[8] = own mine ".encode = random_encode, .decode = random_decode, .blend = QTRI_ALPHA, .fetch = random_fetch, " less
    rare[9] = own ".shade = QTRI_LIGHT, .blend = QTRI_ADD, " less
    rare[10] = mine ".format = QTRI_RGB565, .key = 1, .fetch = random_fetch, .shade = QTRI_TINT, " less
    rare[11] = ".format = QTRI_RGB565, .shade = QTRI_LIGHT, .depth = QTRI_LINEAR24, .compare = QTRI_LESS"
    rare[12] = mine ".format = QTRI_XRGB8888, .key = 1, .bilinear = 1, " less
    rare[13] = ".format = QTRI_RGB565, .blend = QTRI_KEEP_PIXEL, " less
    for (few = 0; few in rare; ) few++
    state = seed * 7919 + 1
    print "/* Made by tests/tools/random_pipelines.awk */"
    print list ? "#include \"qtri/pipeline.h\"" : "#include \"qtri/pipeline_make.h\""
    if (!list) {
        print "bool random_fragment(qtri_fragment *fragment);"
        print "uint32_t random_encode(uint32_t color);"
        print "uint32_t random_decode(uint32_t stored);"
        print "uint32_t random_fetch(const qtri_texture *texture, uint32_t number);"
        print "extern const qtri_format random_format;"
        print "extern const qtri_texel_format random_texels;"
    }
    count = int(count)
    for (i = 0; i < count + few; i++) {
        text = i < count ? options(i) : rare[i - count]
        if (list) print "extern const qtri_pipeline random_" i ";"
        else if (i % parts == part) print "QTRI_PIPELINE(random_" i ", " text ")"
    }
    if (list) {
        print "extern const qtri_pipeline *const random_pipelines[];"
        print "const qtri_pipeline *const random_pipelines[] = {"
        for (i = 0; i < count + few; i++) print "    &random_" i ","
        print "    0};"
    }
}
