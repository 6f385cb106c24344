// What the board's operators take, and what they say where they take nothing.
import { olderThan } from './version.mjs';
import { addressOfText, bodyStart, expressionEnd, flat, onlyFunction, onlyMatch } from './wat.mjs';

/** py/runtime0.h: the operators whose methods (`__add__`) the board knows without MICROPY_PY_ALL_SPECIAL_METHODS. */
const NAMED_BINARY = [0, 1, 2, 3, 4, 14, 15, 27, 28, 36]; // < > == <= >= += -= + - in
const NAMED_UNARY = [4, 5, 6]; // bool, len, hash

export function operateAsTheBoard(module) {
  const sayer = (text) =>
    onlyFunction(
      module,
      text,
      new RegExp(`\\(i32\\.const ${addressOfText(module, text)}\\) \\(local\\.get \\$\\d+\\)`),
    );
  const binary = sayer("unsupported types for %q: '%s', '%s'").name;
  const unary = sayer("unsupported type for %q: '%s'").name;
  nameOnly(module, binary, NAMED_BINARY);
  nameOnly(module, unary, NAMED_UNARY);
  refuseInPlace(module, binary);
  limitProducts(module);
}

/** An operator without a method has no name in the error: "unsupported types for : 'int', 'NoneType'". */
function nameOnly(module, name, named) {
  const text = flat(module.functions.get(name));
  const { index } = onlyMatch(text, 'name of the operator', /\(i32\.load8_u offset=\d+ \(local\.get \$0\)\)\) \(call /);
  const end = expressionEnd(text, index);
  const mask = named.reduce((bits, operator) => bits + 2 ** operator, 0);
  const isNamed = `(i32.wrap_i64 (i64.and (i64.shr_u (i64.const ${mask}) (i64.extend_i32_u (local.get $0))) (i64.const 1)))`;
  module.functions.set(name, `${text.slice(0, index)}(i32.mul ${isNamed} ${text.slice(index, end)})${text.slice(end)}`);
}

/**
 * MicroPython 1.18 goes from `*=` to `*` for numbers, sets, tuples and classes of one's own alone: `text *= 2` and
 * `row *= 9` are TypeErrors there. (py/runtime.c falls back for all since 1.19.) Images have none there either: the library
 * reports the address of their type when it is loaded.
 */
function refuseInPlace(module, binary) {
  const text = flat(module.functions.get(binary));
  const fallback = onlyMatch(
    text,
    'fallback of in-place operators',
    /\(i32\.gt_u \(i32\.add \(local\.get \$0\) \(i32\.const -9\)\) \(i32\.const 12\)\)/,
  );
  const operand = onlyMatch(
    text,
    'left operand',
    /\(call \$(\S+) \(local\.get (\$\d+)\)\)\)\)\)\)\) \(br_if \$\S+ \(local\.tee \$4 \(call_indirect/,
  );
  const [, typeOf, left] = operand;
  module.functions.set(
    binary,
    text.replace(fallback[0], `(i32.or ${fallback[0]} (call $stays_in_place (local.get ${left})))`),
  );
  module.head += '\n (global $image_type (mut i32) (i32.const 0))\n (export "image_type" (global $image_type))';
  const refused = [...bytesAndText(module), listType(module)].map((type) => `(i32.const ${type})`);
  const isRefused = [...refused, '(global.get $image_type)']
    .map((type) => `(i32.eq (local.get $1) ${type})`)
    .reduce((all, one) => `(i32.or ${all} ${one})`);
  module.functions.set(
    'stays_in_place',
    `(func $stays_in_place (param $0 i32) (result i32) (local $1 i32)
      (if (i32.eqz (i32.and ${olderThan(19)} (global.get $in_program))) (then (return (i32.const 0))))
      (local.set $1 (call $${typeOf} (local.get $0)))
      ${isRefused})`,
  );
}

/** py/objstr.c, bytes_make_new: the types bytes and str. */
function bytesAndText(module) {
  const address = addressOfText(module, 'wrong number of arguments');
  const { match } = onlyFunction(
    module,
    'bytes_make_new',
    new RegExp(
      `\\(i32\\.eq \\(local\\.tee \\$\\d+ \\(i32\\.load \\(local\\.get \\$\\d+\\)\\)\\) \\(i32\\.const (\\d+)\\)\\)\\) \\(br_if \\$\\S+ \\(i32\\.ne \\(local\\.get \\$\\d+\\) \\(i32\\.const (\\d+)\\)\\)\\).*\\(i32\\.const ${address}\\)`,
    ),
  );
  return [match[1], match[2]];
}

/** py/objlist.c, list_new: the type list. */
function listType(module) {
  return onlyFunction(
    module,
    'mp_obj_new_list',
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) (?:\(local \$\d+ i32\) )+\(i32\.store offset=8 \(local\.tee \$1 \(call \$\S+ \(i32\.const 16\)\)\) \(local\.get \$0\)\) \(i32\.store \(local\.get \$1\) \(i32\.const (\d+)\)\)/,
  ).match[1];
}

/** More than any board has, and less than what a product of 32 bits can hide. In bytes. */
const MOST_BYTES = 2 ** 27;

/** py/sequence.c, mp_seq_multiply: a product that does not fit into 32 bits got too little memory; it fills none of it. */
function limitProducts(module) {
  const fail = addressOfText(module, 'memory allocation failed, allocating %u bytes');
  const failed = onlyFunction(
    module,
    'm_malloc_fail',
    new RegExp(`^\\(func \\$\\S+ \\(param \\$0 i32\\) .*\\(i32\\.const ${fail}\\)`),
  ).name;
  const multiply = onlyFunction(
    module,
    'mp_seq_multiply',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) \(param \$3 i32\) \(param \$4 i32\) (?:\(local \$\d+ i32\) )*\(block \$\S+ \(br_if \$\S+ \(i32\.eqz \(local\.get \$3\)\)\).*\(memory\.copy \(local\.get \$4\) \(local\.get \$0\)/,
  ).name;
  const text = flat(module.functions.get(multiply));
  const body = bodyStart(text);
  const bytes = [1, 2, 3].map((it) => `(i64.extend_i32_u (local.get $${it}))`).reduce((a, b) => `(i64.mul ${a} ${b})`);
  const check = `(if (i64.gt_u ${bytes} (i64.const ${MOST_BYTES})) (then (call $${failed} (i32.const ${MOST_BYTES}))))`;
  module.functions.set(multiply, `${text.slice(0, body)}${check} ${text.slice(body)}`);
}
