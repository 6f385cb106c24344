/** `error`: the device stops there. `hint`: the device goes on, but may come to another result. */
export type Severity = 'error' | 'hint';

/** Facts about a rule, besides its code and its texts. */
export interface Rule {
  readonly severity: Severity;
  /** MicroPython version that brought it, where a newer firmware has it. */
  readonly since?: readonly [number, number];
  /** Source for firmware v2.1.2 not having it. */
  readonly source: string;
}

/** A rule about a switch of MicroPython's py/mpconfig.h that the device does not set in codal_port/mpconfigport.h. */
const extra = (name: string): Rule => ({
  severity: 'error',
  source: `micropython py/mpconfig.h: MICROPY_PY_${name} needs the level EXTRA_FEATURES, the device has CORE_FEATURES`,
});

/**
 * Every rule: what our MicroPython (1.27, all features) accepts and the micro:bit's firmware v2.1.2 (MicroPython v1.18,
 * level CORE_FEATURES) does not. Switches that the device sets itself are in
 * micropython-microbit-v2 src/codal_port/mpconfigport.h.
 */
export const rules = {
  'f-string': extra('FSTRINGS'),
  'text-method': extra('BUILTINS_STR_CENTER, _PARTITION, _SPLITLINES'),
  'bytes-hex': extra('BUILTINS_BYTES_HEX (before 1.20: where binascii is)'),
  'bytes-fromhex': extra('BUILTINS_BYTES_HEX (before 1.20: where binascii is)'),
  'star-arguments': {
    severity: 'error',
    since: [1, 19],
    source: 'micropython pull request 5807, merged in March 2022: more than one * or **, a plain argument after *',
  },
  'dict-union': {
    severity: 'error',
    since: [1, 20],
    source: 'micropython pull request 8523, merged in November 2022 as f3e4c505',
  },
  'pow-three': extra('BUILTINS_POW3'),
  'round-whole': extra('BUILTINS_ROUND_INT; py/modbuiltins.c: NotImplementedError for a whole number with digits'),
  'next-default': {
    severity: 'error',
    source: 'micropython py/mpconfig.h: MICROPY_PY_BUILTINS_NEXT2 needs a higher level than CORE_FEATURES',
  },
  'not-implemented': extra('BUILTINS_NOTIMPLEMENTED'),
  'builtin-name': extra('BUILTINS_COMPILE, BUILTINS_EXECFILE'),
  'int-bytes': {
    severity: 'error',
    since: [1, 24],
    source: 'micropython pull request 14387 (2024): the byte order became optional',
  },
  'special-method': extra('ALL_SPECIAL_METHODS; __float__ and __complex__: pull request 8857 (2022)'),
  'reverse-method': extra('REVERSE_SPECIAL_METHODS'),
  'attribute-hook': extra('DELATTR_SETATTR'),
  descriptor: extra('DESCRIPTORS'),
  'function-attribute': extra('FUNCTION_ATTRS'),
  'slice-attribute': extra('BUILTINS_SLICE_ATTRS, BUILTINS_SLICE_INDICES'),
  'array-slice': extra('ARRAY_SLICE_ASSIGN'),
  'math-name': extra('MATH_CONSTANTS (pull request 8159, 2022), MATH_SPECIAL_FUNCTIONS, MATH_ISCLOSE'),
  'math-missing': extra('MATH_FACTORIAL, MATH_SPECIAL_FUNCTIONS'),
  deque: extra('COLLECTIONS_DEQUE'),
  'time-name': {
    severity: 'error',
    source: 'micropython-microbit-v2 modutime.c: sleep, sleep_ms, sleep_us, ticks_ms, _us, _add, _diff and no more',
  },
  'type-name': {
    severity: 'error',
    source: 'micropython-microbit-stubs names these types; the tables of modmicrobit.c and moduos.c do not',
  },
  module: {
    severity: 'error',
    source: "help('modules') of the device; micropython-microbit-v2 mpconfigport.h, MICROPY_PORT_BUILTIN_MODULES",
  },
  'module-instead': {
    severity: 'error',
    source: "help('modules') of the device; micropython-microbit-v2 mpconfigport.h, MICROPY_PORT_BUILTIN_MODULES",
  },
  'not-iterable': {
    severity: 'error',
    source: 'micropython-microbit-v2 v2.1.2: microbitfs.c and modaudio.c give their types no iterator',
  },
  'in-place': {
    severity: 'error',
    since: [1, 19],
    source: 'micropython v1.18 py/runtime.c, mp_binary_op: no way from an in-place operator to the plain one',
  },
  'starts-ends': {
    severity: 'error',
    source:
      'micropython py/objstr.c, str_startswith and str_endswith, v1.18 and v1.23: one text, a start for startswith alone',
  },
  'array-method': {
    severity: 'error',
    since: [1, 23],
    source:
      'micropython v1.18 py/objarray.c: the table of bytearray has append, extend and decode; v1.23 has those of bytes',
  },
  'struct-x': {
    severity: 'error',
    since: [1, 23],
    source: 'micropython v1.18 py/binary.c: no padding bytes',
  },
  'timer-without-time': {
    severity: 'error',
    source: 'micropython-microbit-v2 drv_softtimer.c: a period of 0 is served again and again, in the interrupt',
  },
  'newer-name': {
    severity: 'error',
    source: 'micropython-microbit-v2: in the tables of its master and audio-recording branches, not in v2.1.2',
  },
} as const satisfies Readonly<Record<string, Rule>>;

/** The name of a rule. */
export type RuleId = keyof typeof rules;

/** Facts about a rule. */
export const ruleOf = (id: RuleId): Rule => rules[id];
