/* {{ name }}.h: {{ title }}
 *
{%- for line in lines %}
 *{% if !line.is_empty() %} {{ line }}{% endif %}
{%- endfor %}
 */
#ifndef {{ upper }}_H
#define {{ upper }}_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Seconds between two calls of {{ name }}_step. */
#define {{ upper }}_SAMPLE_TIME {{ sample_time }}

typedef enum {
    {{ upper }}_CONVERGING = 0, /* not yet: the estimate is the start, or what was last known */
    {{ upper }}_CONVERGED = 1,  /* the estimate is what the header promises */
    {{ upper }}_COASTING = 2    /* a missing sample was replaced by the model's prediction */
} {{ name }}_status;

/* Sampled now. */
typedef struct {
{%- for field in measurements %}
    {{ field }}
{%- endfor %}
} {{ name }}_measurements;
{%- if !inputs.is_empty() %}

/* Applied since the previous call. */
typedef struct {
{%- for field in inputs %}
    {{ field }}
{%- endfor %}
} {{ name }}_inputs;
{%- endif %}

/* The state, and how far it is to be trusted. */
typedef struct {
{%- for field in estimates %}
    {{ field }}
{%- endfor %}
} {{ name }}_estimate;

/* The observer's whole state, owned by the caller; plain data, may be copied. */
typedef struct {
{%- for cell in cells %}
    {{ cell }}
{%- endfor %}
{%- if cells.is_empty() %}
    uint8_t reserved; /* this observer remembers nothing; a struct of C is not empty */
{%- endif %}
} {{ name }}_state;

/* Back to the state before the first sample. */
void {{ name }}_init({{ name }}_state *state);
{%- if starts_at %}

/* From an estimate, as behind the call that gave it: the first step is one sample time later. A status of
 * {{ upper }}_CONVERGED vouches for it, and the first step answers that status at once. */
void {{ name }}_init_at({{ name }}_state *state, const {{ name }}_estimate *estimate);
{%- endif %}
{% if inputs.is_empty() %}
/* One sample: takes the measurements, gives the estimate. */
{%- else %}
/* One sample: takes the measurements and the inputs applied since the previous call, gives the
 * estimate. */
{%- endif %}
void {{ name }}_step({{ name }}_state *state, const {{ name }}_measurements *measurements,
{{ indent }}{% if !inputs.is_empty() %}const {{ name }}_inputs *inputs, {% endif %}{{ name }}_estimate *estimate);

#ifdef __cplusplus
}
#endif

#endif
