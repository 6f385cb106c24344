// The board's MicroPython computes with single floats (32 bits), the published build with doubles. Here every float
// object holds a number that a single float can hold, and each step towards it is rounded as the board rounds it.
//
// Adding, subtracting, multiplying, dividing and taking a root of two singles in double and rounding then gives the
// single result exactly (53 bits are more than twice 24 and two), so these operations stay in double. Reading and
// writing decimal numbers is different: the board does that in single steps of its own (../run/single-float-text.ts).
import { addressOfText, expressionEnd, flat, onlyFunction, replaceBytes } from './wat.mjs';

/** Operations on doubles whose result a single may not hold. */
const INEXACT = /\((?:f64\.(?:add|sub|mul|div|sqrt|convert_\w+) |call_indirect \$\S+ \(type \$(\S+)\) |call \$(\S+) )/g;

export function computeInSingles(module) {
  const create = onlyFunction(
    module,
    'mp_obj_new_float',
    /^\(func \$\S+ \(param \$0 f64\) \(result i32\) \(local \$1 i32\) \(f64\.store offset=8 \(local\.tee \$1 \(call \$\S+ \(i32\.const 16\)\)\) \(local\.get \$0\)\) \(i32\.store \(local\.get \$1\) \(i32\.const (\d+)\)\) \(local\.get \$1\)\)$/,
  );
  const floatType = create.match[1];
  const value = onlyFunction(
    module,
    'mp_obj_float_get',
    /^\(func \$\S+ \(param \$0 i32\) \(result f64\) \(f64\.load offset=8 \(local\.get \$0\)\)\)$/,
  );
  const number = onlyFunction(
    module,
    'mp_obj_get_float',
    new RegExp(
      `^\\(func \\$\\S+ \\(param \\$0 i32\\) \\(result f64\\).*\\(i32\\.const ${addressOfText(module, "can't convert %s to float")}\\)`,
    ),
  );
  const bigNumber = onlyFunction(
    module,
    'mpz_as_float',
    /^\(func \$\S+ \(param \$0 i32\) \(result f64\).*\(f64\.mul \(local\.get \$\d+\) \(f64\.const 65536\)\)/,
  );
  const divide = onlyFunction(
    module,
    'mp_obj_float_divmod',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(local \$2 f64\).*\(f64\.copysign .*\(f64\.floor .*\(f64\.store \(local\.get \$1\)/,
  );
  const uses = new RegExp(
    `\\(call \\$(?:${[create.name, value.name, number.name].join('|')}) |\\(i32\\.const ${floatType}\\)`,
  );
  const results = resultTypes(module);
  const complex = onlyFunction(
    module,
    'mp_obj_complex_binary_op',
    new RegExp(
      `^\\(func \\$\\S+ \\(param \\$0 i32\\) \\(param \\$1 f64\\) .*\\(i32\\.const ${addressOfText(module, '0.0 to a complex power')}\\)`,
    ),
  );
  const singles = new Set([create.name, bigNumber.name, divide.name, complex.name]);
  for (const [name, text] of module.functions) if (/f64/.test(text) && uses.test(flat(text))) singles.add(name);
  // What these return is rounded already.
  const rounded = new Set([value.name, number.name, bigNumber.name]);
  drawInSingles(module);
  for (const name of singles)
    module.functions.set(name, roundEachStep(flat(module.functions.get(name)), results, rounded));
  roundWhatIsStored(module, create.name);
  roundConstants(module, Number(floatType));
  writeAsTheBoard(module);
  readAsTheBoard(module);
}

const round = (expression) => `(f64.promote_f32 (f32.demote_f64 ${expression}))`;

/** The functions and the types of functions that give a double. */
function resultTypes(module) {
  const doubles = new Set();
  for (const [name, text] of module.functions)
    if (/^\(func \$\S+(?: \(type \$\S+\))?(?: \(param [^)]*\))* \(result f64\)/.test(flat(text))) doubles.add(name);
  const types = new Set(
    [...flat(module.head).matchAll(/\(type \$(\S+) \(func(?: \(param [^)]*\))? \(result f64\)\)\)/g)].map(
      ([, name]) => name,
    ),
  );
  return { doubles, types };
}

function roundEachStep(text, { doubles, types }, rounded) {
  const insertions = [];
  for (const match of text.matchAll(INEXACT)) {
    const [, type, called] = match;
    if (type !== undefined && !types.has(type)) continue;
    if (called !== undefined && (!doubles.has(called) || rounded.has(called))) continue;
    const end = expressionEnd(text, match.index);
    insertions.push({ at: match.index, text: '(f64.promote_f32 (f32.demote_f64 ' }, { at: end, text: '))' });
  }
  insertions.sort((a, b) => a.at - b.at);
  let result = '';
  let done = 0;
  for (const { at, text: added } of insertions) {
    result += text.slice(done, at) + added;
    done = at;
  }
  return (result + text.slice(done)).replace(
    /\(f64\.const ([-+.\de]+)\)/g,
    (_, constant) => `(f64.const ${singleConstant(Number(constant))})`,
  );
}

/** The board divides 180 by pi in singles, which is not the single next to the quotient. */
const singleConstant = (value) => Math.fround(value === 180 / Math.PI ? 180 / Math.fround(Math.PI) : value);

/** Values that come from elsewhere (the bytes of an array, a host object) are rounded as they become an object. */
function roundWhatIsStored(module, create) {
  const text = flat(module.functions.get(create));
  module.functions.set(create, text.replace('(local.get $0)) (i32.store', `${round('(local.get $0)')}) (i32.store`));
}

/** Constants such as math.pi lie in memory from the start: type, four bytes, double. */
function roundConstants(module, floatType) {
  let count = 0;
  replaceBytes(module, (bytes, start) => {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    for (let at = (8 - (start % 8)) % 8; at + 16 <= bytes.length; at += 8) {
      if (view.getUint32(at, true) !== floatType || view.getUint32(at + 4, true) !== 0) continue;
      view.setFloat64(at + 8, Math.fround(view.getFloat64(at + 8, true)), true);
      count++;
    }
  });
  if (count !== 5) throw new Error(`Float constants: expected 5, found ${count}.`);
}

/** random() fills the 23 bits of a single's fraction from one draw; in double it takes 52 bits from two. */
function drawInSingles(module) {
  const draw =
    /\(f64\.reinterpret_i64 \(i64\.or \(i64\.or \(i64\.and \(i64\.shl \(i64\.extend_i32_u \(call \$(\S+)\)\) \(i64\.const 32\)\) \(i64\.const 4503595332403200\)\) \(i64\.extend_i32_u \(call \$\1\)\)\) \(i64\.const 4607182418800017408\)\)\)/;
  let count = 0;
  for (const [name, text] of module.functions) {
    const line = flat(text);
    if (!draw.test(line)) continue;
    count++;
    module.functions.set(
      name,
      line.replace(
        draw,
        '(f64.promote_f32 (f32.reinterpret_i32 (i32.or (i32.and (call $$$1) (i32.const 8388607)) (i32.const 1065353216))))',
      ),
    );
  }
  if (count !== 2) throw new Error(`random() and uniform(): expected 2 places, found ${count}.`);
}

/** mp_format_float becomes a call of the host. */
function writeAsTheBoard(module) {
  const format = onlyFunction(
    module,
    'mp_format_float',
    /^\(func \$\S+ \(param \$0 f64\) \(param \$1 i32\) \(param \$2 i32\) \(param \$3 i32\) \(param \$4 i32\) \(param \$5 i32\) \(result i32\).*\(f64\.const 0\.3010299956639812\)/,
  );
  importHost(module, 'format_single', '(param f64 i32 i32 i32 i32) (result i32)');
  // The buffer's size (the third parameter) is the published build's; the host knows the board's.
  module.functions.set(
    format.name,
    `(func $${format.name} (param $0 f64) (param $1 i32) (param $2 i32) (param $3 i32) (param $4 i32) (param $5 i32) (result i32)
      (call $format_single (local.get $0) (local.get $1) (local.get $3) (local.get $4) (local.get $5)))`,
  );
}

/** mp_parse_float_internal finds where the digits end; the host says which number they are. */
function readAsTheBoard(module) {
  const parse = onlyFunction(
    module,
    'mp_parse_float_internal',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) \(result i32\).*\(i64\.const 1844674407370955159\).*\(f64\.store \(local\.get \$2\)/,
  );
  importHost(module, 'parse_single', '(param i32 i32) (result f64)');
  const text = flat(module.functions.get(parse.name));
  module.functions.set('find_number', text.replace(`$${parse.name}`, '$find_number'));
  module.functions.set(
    parse.name,
    `(func $${parse.name} (param $0 i32) (param $1 i32) (param $2 i32) (result i32) (local $3 i32)
      (local.set $3 (call $find_number (local.get $0) (local.get $1) (local.get $2)))
      (if (local.get $3) (then
        (f64.store (local.get $2) (call $parse_single (local.get $0) (i32.sub (local.get $3) (local.get $0))))))
      (local.get $3))`,
  );
}

function importHost(module, name, type) {
  const end = expressionEnd(module.head, module.head.lastIndexOf('(import '));
  module.head = `${module.head.slice(0, end)}\n (import "host" "${name}" (func $${name} ${type}))${module.head.slice(end)}`;
}
