// The functions of the device's modules are C code, those of our library Python. A program that calls one wrongly gets
// the words of the C code all the same: py/argcheck.c instead of py/bc.c.
import { addressOfText, bodyStart, flat, onlyFunction, onlyMatch } from './wat.mjs';

/**
 * The kind of a library function, seen from outside, by how its Python is written:
 *
 * - 0: Python on the device, too (NeoPixel): the first parameter's name begins with `_`.
 * - 1: MP_DEFINE_CONST_FUN_OBJ_0 … 3 and _VAR: no parameter can be left out, and none be named.
 * - 2: MP_DEFINE_CONST_FUN_OBJ_VAR_BETWEEN: the last parameter's name begins with `_`. Some can be left out, none be
 *   named.
 * - 3: MP_DEFINE_CONST_FUN_OBJ_KW with mp_arg_parse_all: the others with defaults.
 * - 4: the same, and the first arguments are taken before that: it has `**`.
 */
const KIND = `(func $call_kind (param $fun i32) (result i32)
  (call $read_signature (local.get $fun))
  (if (i32.and (global.get $call_flags) (i32.const 2)) (then (return (i32.const 4))))
  (if (global.get $call_named) (then (return (i32.const 3))))
  (if (i32.eqz (global.get $call_positional)) (then (return (i32.const 1))))
  (if (global.get $call_optional) (then
    (if (call $is_private (local.get $fun) (i32.sub (global.get $call_positional) (i32.const 1)))
      (then (return (i32.const 2))))))
  (if (call $is_private (local.get $fun) (i32.const 0)) (then (return (i32.const 0))))
  (select (i32.const 3) (i32.const 1) (global.get $call_optional)))`;

/** py/bc.h, MP_BC_PRELUDE_SIG_DECODE and MP_BC_PRELUDE_SIZE_DECODE: the bits xSSSSEAA, then xFSSKAED. */
const SIGNATURE = `(func $read_signature (param $fun i32) (local $at i32) (local $byte i32) (local $shift i32)
  (local.set $at (i32.load offset=12 (local.get $fun)))
  (local.set $byte (i32.load8_u (local.get $at)))
  (global.set $call_positional (i32.and (local.get $byte) (i32.const 3)))
  (global.set $call_flags (i32.const 0))
  (global.set $call_named (i32.const 0))
  (global.set $call_optional (i32.const 0))
  (block $end (loop $next
    (local.set $at (i32.add (local.get $at) (i32.const 1)))
    (br_if $end (i32.eqz (i32.and (local.get $byte) (i32.const 0x80))))
    (local.set $byte (i32.load8_u (local.get $at)))
    (global.set $call_flags (i32.or (global.get $call_flags)
      (i32.shl (i32.and (i32.shr_u (local.get $byte) (i32.const 6)) (i32.const 1)) (local.get $shift))))
    (global.set $call_positional (i32.or (global.get $call_positional)
      (i32.shl (i32.and (local.get $byte) (i32.const 4)) (local.get $shift))))
    (global.set $call_named (i32.or (global.get $call_named)
      (i32.shl (i32.and (i32.shr_u (local.get $byte) (i32.const 3)) (i32.const 1)) (local.get $shift))))
    (global.set $call_optional (i32.or (global.get $call_optional)
      (i32.shl (i32.and (local.get $byte) (i32.const 1)) (local.get $shift))))
    (local.set $shift (i32.add (local.get $shift) (i32.const 1)))
    (br $next)))
  (block $sized (loop $size
    (local.set $byte (i32.load8_u (local.get $at)))
    (local.set $at (i32.add (local.get $at) (i32.const 1)))
    (br_if $size (i32.and (local.get $byte) (i32.const 0x80)))))
  (global.set $call_names (local.get $at)))`;

/** The name (qstr) of a parameter: it comes after the function's own, as a number in the module's table of names. */
const PARAMETER = `(func $parameter (param $fun i32) (param $index i32) (result i32)
  (local $at i32) (local $byte i32) (local $number i32)
  (local.set $at (global.get $call_names))
  (local.set $index (i32.add (local.get $index) (i32.const 1)))
  (loop $next
    (local.set $number (i32.const 0))
    (loop $digit
      (local.set $byte (i32.load8_u (local.get $at)))
      (local.set $at (i32.add (local.get $at) (i32.const 1)))
      (local.set $number (i32.or (i32.shl (local.get $number) (i32.const 7)) (i32.and (local.get $byte) (i32.const 127))))
      (br_if $digit (i32.and (local.get $byte) (i32.const 0x80))))
    (if (local.get $index) (then
      (local.set $index (i32.sub (local.get $index) (i32.const 1)))
      (br $next))))
  (i32.load16_u (i32.add
    (i32.load offset=8 (i32.load offset=4 (local.get $fun)))
    (i32.shl (local.get $number) (i32.const 1)))))`;

const IS_OURS = '(i32.lt_u (i32.load offset=12 (local.get $fun)) (global.get $program_start))';

/** Before a call with named arguments by the program. The library calls itself as Python does. */
const NAMED = `(func $heed_named (param $fun i32) (param $arguments i32) (local $kind i32)
  (global.set $call_arguments (local.get $arguments))
  (if (i32.and (global.get $in_program) ${IS_OURS}) (then
    (local.set $kind (call $call_kind (local.get $fun)))
    (if (i32.or (i32.eq (local.get $kind) (i32.const 1)) (i32.eq (local.get $kind) (i32.const 2)))
      (then (call $RAISE_PLAIN (i32.const NONE_NAMED)))))))`;

/** In place of "function takes … positional arguments but … were given". */
const COUNT = `(func $refuse_count (param $fun i32) (param $wanted i32) (param $given i32) (local $kind i32)
  (if (i32.eqz ${IS_OURS}) (then (return)))
  (local.set $kind (call $call_kind (local.get $fun)))
  (if (i32.lt_u (local.get $kind) (i32.const 2)) (then (return)))
  (if (i32.ge_u (local.get $given) (local.get $wanted)) (then
    (if (i32.ne (local.get $kind) (i32.const 2)) (then (call $RAISE_PLAIN (i32.const EXTRA_POSITIONAL))))
    (call $raise_call (i32.const TOO_MANY) (local.get $wanted) (local.get $given))))
  (if (i32.eq (local.get $kind) (i32.const 3)) (then
    (call $raise_call (i32.const REQUIRED) (call $parameter (local.get $fun) (local.get $given)) (i32.const 0))))
  (call $raise_call (i32.const TOO_FEW) (i32.sub (local.get $wanted) (local.get $given)) (i32.const 0)))`;

/** mp_arg_parse_all looks at the parameters in their order: the first one that must be there and is not. */
const LACKING = `(func $refuse_lacking (param $fun i32) (local $index i32) (local $place i32) (local $name i32)
  (local.set $index (global.get $call_given))
  (block $complete (loop $next
    (br_if $complete (i32.ge_s (local.get $index) (i32.sub (global.get $call_positional) (global.get $call_optional))))
    (local.set $name (call $parameter (local.get $fun) (local.get $index)))
    (local.set $place (i32.const 0))
    (block $found
      (loop $other
        (if (i32.lt_u (local.get $place) (global.get $call_extra)) (then
          (br_if $found (i32.eq (local.get $name) (i32.shr_u (i32.load (i32.add
            (global.get $call_arguments)
            (i32.shl (i32.add (global.get $call_given) (i32.shl (local.get $place) (i32.const 1))) (i32.const 2))))
            (i32.const 3))))
          (local.set $place (i32.add (local.get $place) (i32.const 1)))
          (br $other))))
      (call $raise_call (i32.const REQUIRED) (local.get $name) (i32.const 0)))
    (local.set $index (i32.add (local.get $index) (i32.const 1)))
    (br $next))))`;

/** In place of "function missing required positional argument". */
const MISSING = `(func $refuse_missing (param $fun i32) (local $kind i32)
  (if (i32.eqz ${IS_OURS}) (then (return)))
  (local.set $kind (call $call_kind (local.get $fun)))
  (if (i32.eq (local.get $kind) (i32.const 3)) (then (call $refuse_lacking (local.get $fun))))
  (if (i32.eq (local.get $kind) (i32.const 4)) (then
    (call $raise_call
      (i32.const TOO_FEW)
      (i32.sub (i32.sub (global.get $call_positional) (global.get $call_optional)) (global.get $call_given))
      (i32.const 0)))))`;

/** In place of "unexpected keyword argument" and "function got multiple values for argument". */
const UNKNOWN = `(func $refuse_named (param $fun i32)
  (if (i32.eqz ${IS_OURS}) (then (return)))
  (if (i32.ne (call $call_kind (local.get $fun)) (i32.const 3)) (then (return)))
  (call $refuse_lacking (local.get $fun))
  (call $RAISE_PLAIN (i32.const EXTRA_NAMED)))`;

/** A TypeError of this text with two values. */
const RAISE = `(func $raise_call (param $text i32) (param $one i32) (param $other i32) (local $values i32)
  (global.set $__stack_pointer (local.tee $values (i32.sub (global.get $__stack_pointer) (i32.const 16))))
  (i32.store (local.get $values) (local.get $one))
  (i32.store offset=4 (local.get $values) (local.get $other))
  (call $RAISE (i32.const TYPE_ERROR) (local.get $text) (local.get $values))
  (unreachable))`;

const PRIVATE = `(func $is_private (param $fun i32) (param $index i32) (result i32)
  (i32.eq (i32.load8_u (call $TEXT_OF (call $parameter (local.get $fun) (local.get $index)))) (i32.const 95)))`;

const GLOBALS = 'positional optional named flags names given extra arguments'
  .split(' ')
  .map((name) => ` (global $call_${name} (mut i32) (i32.const 0))`)
  .join('\n');

const TAKES = '%q() takes %d positional arguments but %d were given';
const MANY = "function got multiple values for argument '%q'";
const NEW = "unexpected keyword argument '%q'";
const LACKS = 'function missing required positional argument #%d';

export function refuseCallsAsNative(module) {
  const set = setUpOf(module);
  const values = { ...raisersOf(module, set), ...textsOf(module), TEXT_OF: textOfName(module) };
  for (const text of [KIND, SIGNATURE, PARAMETER, NAMED, COUNT, LACKING, MISSING, UNKNOWN, RAISE, PRIVATE]) {
    const whole = text.replace(/\b[A-Z][A-Z_]+\b/g, (name) => values[name] ?? name);
    module.functions.set(/^\(func \$(\w+)/.exec(whole)[1], whole);
  }
  module.head += `\n${GLOBALS}`;
  askFirst(module, set);
  const mismatch = onlyFunction(
    module,
    'fun_pos_args_mismatch',
    new RegExp(`^\\(func \\$\\S+ ${'\\(param \\$\\d i32\\) '.repeat(3)}\\(local .*${constant(module, TAKES)}`),
  ).name;
  insertFirst(module, mismatch, '(call $refuse_count (local.get $0) (local.get $1) (local.get $2))');
}

const constant = (module, text) => `\\(i32\\.const ${addressOfText(module, text)}\\)`;

const setUpOf = (module) =>
  onlyFunction(
    module,
    'mp_setup_code_state',
    new RegExp(constant(module, "function missing required keyword argument '%q'")),
  ).name;

/** mp_raise_msg_varg, the type TypeError, and mp_raise_TypeError. */
function raisersOf(module, set) {
  const text = flat(module.functions.get(set));
  const raise = onlyMatch(
    text,
    'error with a value',
    new RegExp(`\\(call \\$(\\S+) \\(i32\\.const (\\d+)\\) ${constant(module, NEW)}`),
  );
  const plain = onlyMatch(
    text,
    'error without a value',
    new RegExp(`\\(call \\$(\\S+) ${constant(module, 'function missing keyword-only argument')}\\)`),
  );
  return { RAISE: raise[1], TYPE_ERROR: raise[2], RAISE_PLAIN: plain[1] };
}

const textsOf = (module) => ({
  NONE_NAMED: addressOfText(module, "function doesn't take keyword arguments"),
  EXTRA_POSITIONAL: addressOfText(module, 'extra positional arguments given'),
  EXTRA_NAMED: addressOfText(module, 'extra keyword arguments given'),
  REQUIRED: addressOfText(module, "'%q' argument required"),
  TOO_FEW: addressOfText(module, 'function missing %d required positional arguments'),
  TOO_MANY: addressOfText(module, 'function expected at most %d arguments, got %d'),
});

/** qstr_str, as mp_obj_get_type_str calls it. */
const textOfName = (module) =>
  onlyFunction(
    module,
    'mp_obj_get_type_str',
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) \(call \$(\S+) \(i32\.load16_u offset=6 \(i32\.load \(select /,
  ).match[1];

/** mp_setup_code_state(code_state, n_args, n_kw, args): the function is the first word of code_state. */
function askFirst(module, set) {
  const fun = '(i32.load (local.get $0))';
  const before = (text, ask) => {
    const whole = flat(module.functions.get(set));
    const error = onlyMatch(
      whole,
      text,
      new RegExp(`\\(call \\$\\S+ \\(i32\\.const \\d+\\) ${constant(module, text)} `),
    );
    module.functions.set(set, `${whole.slice(0, error.index)}${ask} ${whole.slice(error.index)}`);
  };
  before(MANY, `(call $refuse_named ${fun})`);
  before(NEW, `(call $refuse_named ${fun})`);
  before(LACKS, `(call $refuse_missing ${fun})`);
  insertFirst(
    module,
    set,
    `(global.set $call_given (local.get $1))
    (global.set $call_extra (local.get $2))
    (if (local.get $2) (then (call $heed_named ${fun} (local.get $3))))`,
  );
}

function insertFirst(module, name, instructions) {
  const text = flat(module.functions.get(name));
  const body = bodyStart(text);
  module.functions.set(name, `${text.slice(0, body)}${instructions} ${text.slice(body)}`);
}
