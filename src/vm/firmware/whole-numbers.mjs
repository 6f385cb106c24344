// The board's MicroPython (1.18 and 1.23) reads whole numbers more freely than the published build: zeros before a number
// are no error (`hour = 08`), and a text may say its base (`int("0x1F")`). It writes what fits into the bytes it is
// given, and cuts off the rest (`(300).to_bytes(1, "little")`), up to 1.24.
import { addressOfText, flat, onlyFunction, onlyMatch, replaceOnce } from './wat.mjs';

export function readWholeNumbersAsTheBoard(module) {
  readAnyBase(module);
  cutBytes(module);
}

function readAnyBase(module) {
  const base = onlyFunction(
    module,
    'mp_parse_num_base',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) \(result i32\).*\(i32\.const 120\).*\(i32\.const 111\).*\(i32\.const 98\).*\(i32\.store \(local\.get \$2\) \(local\.get \$3\)\)/,
  ).name;
  // Base 1 stands for "zeros alone".
  replaceOnce(
    module,
    base,
    'base of a number that starts with 0',
    /\(local\.set \$3 \(i32\.const 1\)\)/,
    '(local.set $3 (i32.const 10))',
  );
  const read =
    /(\(i32\.load offset=4 \(local\.get \$4\)\) \(i32\.load offset=8 \(local\.get \$4\)\) )\(i32\.const 10\) \(i32\.const 0\)/;
  const make = onlyFunction(
    module,
    'int_make_new',
    new RegExp(`^\\(func \\$\\S+ (?:\\(param \\$\\d i32\\) ){4}\\(result i32\\).*${read.source}`),
  ).name;
  onlyMatch(flat(module.functions.get(make)), 'base of int()', read);
  replaceOnce(module, make, 'base of int()', read, '$1(i32.const 0) (i32.const 0)');
}

/** py/objint.c, int_to_bytes, and py/mpz.c, mpz_as_bytes: no OverflowError; what lies beyond the number's own bytes is 0. */
function cutBytes(module) {
  const tooSmall = `(i32.const ${addressOfText(module, 'buffer too small')})) (unreachable))`;
  const { name, match } = onlyFunction(
    { functions: new Map([...module.functions].filter(([, text]) => flat(text).endsWith(tooSmall))) },
    'int_to_bytes',
    /\(br_if (\$\S+) (\(call \$(\S+) (?:\(local\.get \$\d\) ?){4}\))\) \(br (\$\w+)\)/,
  );
  const [both, done, write, writeBig, overflow] = match;
  const replace = (what, text, by) => replaceOnce(module, name, what, escaped(text), () => by);
  replace('overflow of a big number', both, `(drop ${write}) (br ${done})`);
  replace(
    'overflow of a number',
    `(br_if ${overflow} (i32.lt_u (local.get $3) (local.get $6)))`,
    '(local.set $6 (select (local.get $3) (i32.const 4) (i32.lt_u (local.get $3) (i32.const 4))))',
  );
  replace('sign of a number', '(i32.shr_s (local.get $1) (i32.const 31))', '(i32.const 0)');
  const digits = /\(call \$(\S+) /.exec(flat(module.functions.get(writeBig)))[1];
  replaceOnce(
    module,
    digits,
    'sign of a big number',
    escaped('(i32.sub (i32.const 0) (i32.and (i32.load8_u (local.get $0)) (i32.const 1)))'),
    () => '(i32.const 0)',
  );
}

const escaped = (text) => new RegExp(text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'));
