/* {{ name }}.c: {{ title }}
 *
 * Generated; {{ name }}.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "{{ name }}.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "{{ name }}.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "{{ name }}.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif
{%- for table in tables %}

/* {{ table.title }}
{%- for line in table.columns %}
 *   {{ line }}
{%- endfor %}
 */
static const {{ table.scalar }} {{ table.name }} = {
{%- for row in table.rows %}
{{ row }}
{%- endfor %}
};
{%- endfor %}
{%- for fragment in runtime %}

{{ fragment }}
{%- endfor %}
{%- if !work.is_empty() || flag_count > 0 %}

/* What one part of a step hands to the next. */
typedef struct {
{%- for field in work %}
    {{ field }};
{%- endfor %}
{%- if flag_count > 0 %}
    int flags[{{ flag_count }}]; /* {{ flags }} */
{%- endif %}
} {{ name }}_work;
{%- endif %}
{%- for part in parts %}

/* {{ part.doc }} */
static void {{ name }}_{{ part.name }}({{ part.parameters }})
{
{%- for line in part.lines %}
{%- if line.is_empty() %}
{% else %}
    {{ line }}
{%- endif %}
{%- endfor %}
}
{%- endfor %}

void {{ name }}_init({{ name }}_state *state)
{
{%- for line in starts %}
    {{ line }}
{%- endfor %}
{%- if starts.is_empty() %}
    state->reserved = 0U;
{%- endif %}
}
{%- if let Some(lines) = start %}

void {{ name }}_init_at({{ name }}_state *state, const {{ name }}_estimate *estimate)
{
    {{ name }}_init(state);
{%- for line in lines %}
{%- if line.is_empty() %}
{% else %}
    {{ line }}
{%- endif %}
{%- endfor %}
}
{%- endif %}

void {{ name }}_step({{ name }}_state *state, const {{ name }}_measurements *measurements,
{{ indent }}{% if has_inputs %}const {{ name }}_inputs *inputs, {% endif %}{{ name }}_estimate *estimate)
{
{%- for line in step %}
{%- if line.is_empty() %}
{% else %}
    {{ line }}
{%- endif %}
{%- endfor %}
}
