// The board's MicroPython (1.18 and 1.23) reads whole numbers more freely than the published build: zeros before a number
// are no error (`hour = 08`), and a text may say its base (`int("0x1F")`).
import { flat, onlyFunction, onlyMatch, replaceOnce } from './wat.mjs';

export function readWholeNumbersAsTheBoard(module) {
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
