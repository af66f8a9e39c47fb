#include "qtri/texture.h"

struct qtri_filter {
    uint8_t taps; /* texels across and down */
};

const qtri_filter qtri_bilinear = {2};
