// What the board's MicroPython 1.18 does not read yet, and 1.23 does: `x` in a format of struct, a complex number in a text.
import { olderThan } from './version.mjs';
import { addressOfText, onlyFunction, replaceOnce } from './wat.mjs';

const IS_OLDER = olderThan(23);

export function readFormatsAsTheBoard(module) {
  // py/modstruct.c, calc_size_items: without the sign for a byte to skip, it is an unknown one ("bad typecode").
  const PAD = 'x'.charCodeAt(0);
  const STRING = 's'.charCodeAt(0);
  const pad = `\\(br_if (\\$\\S+) \\(i32\\.ne \\(local\\.get \\$5\\) \\(i32\\.const ${PAD}\\)\\)\\)`;
  const sizes = onlyFunction(
    module,
    'calc_size_items',
    new RegExp(
      `^\\(func \\$\\S+ \\(param \\$0 i32\\) \\(param \\$1 i32\\) \\(result i32\\).*\\(i32\\.const ${STRING}\\)\\)\\) ${pad}`,
    ),
  );
  const label = sizes.match[1];
  replaceOnce(module, sizes.name, 'x', new RegExp(pad), (found) => `(br_if ${label} ${IS_OLDER}) ${found}`);
  // py/parsenum.c, mp_parse_num_decimal: nothing may come after the first number of "1+2j".
  const number = onlyFunction(
    module,
    'mp_parse_num_float',
    new RegExp(`\\(i32\\.const ${addressOfText(module, 'invalid syntax for number')}\\)`),
  ).name;
  replaceOnce(
    module,
    number,
    'second part of a complex number',
    /\(br_if (\$\S+) \(i32\.eqz \(local\.get \$3\)\)\) (?=\(br_if \1 \(local\.get \$8\)\))/,
    (found, end) => `${found}(br_if ${end} ${IS_OLDER}) `,
  );
}
