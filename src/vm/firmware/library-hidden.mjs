// The device's modules are C code: a program sees their public names and no more. Ours are Python, and what they are made
// of (the simulation's functions, other parts of the library) would be in reach as `music._hal` or
// `type(display).scroll.__globals__`. Here a program finds neither; the library itself does.
import { addressOfText, bodyStart, flat, only, onlyFunction, onlyMatch, replaceOnce } from './wat.mjs';

const UNDERSCORE = '_'.charCodeAt(0);

/** Call it while functions have the shape in which they were published. */
export function hideLibrary(module) {
  hideInsidesOfFunctions(module);
  hideOwnNames(module);
  hideFromLists(module);
}

/**
 * py/objfun.c, mp_obj_fun_bc_attr: `__name__`, `__globals__`, `__code__`. The device's functions have none of them, and
 * its MicroPython knows no `__code__` at all.
 */
function hideInsidesOfFunctions(module) {
  const shape =
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) \(local \$3 i64\) \(block (\$\S+) \(br_if \1 \(i32\.load \(local\.get \$2\)\)\) .*\(br_if \$\S+ \(i32\.eq \(local\.get \$1\) \(i32\.const (\d+)\)\)\) \(br_if \$\S+ \(i32\.eq \(local\.get \$1\) \(i32\.const (\d+)\)\)\)/;
  const { name, match } = onlyFunction(module, 'fun_bc_attr', shape);
  const [, , , code] = match;
  const text = flat(module.functions.get(name));
  const guard = `(if (i32.or
      (i32.lt_u (i32.load offset=12 (local.get $0)) (global.get $program_start))
      (i32.eq (local.get $1) (i32.const ${code})))
    (then (return)))`;
  module.functions.set(name, `${text.slice(0, bodyStart(text))}${guard} ${text.slice(bodyStart(text))}`);
}

/** py/objmodule.c, module_attr: names with one underscore in front, and `__dict__`, which would hold them. */
function hideOwnNames(module) {
  const { name: attribute, match } = onlyFunction(
    module,
    'module_attr',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) .*\(i32\.load offset=4 \(local\.get \$0\)\).*\(br_if \$\S+ \(i32\.eqz \(i32\.and \(i32\.load8_u \(local\.get \$\d+\)\) \(i32\.const 2\)\)\)\)/,
  );
  const dictionary = onlyMatch(
    match[0],
    '__dict__',
    String.raw`\(i32\.ne \(local\.get \$1\) \(i32\.const (\d+)\)\)\) \(i32\.store \(local\.get \$2\) \(i32\.load offset=4 \(local\.get \$0\)\)\)`,
  )[1];
  const qstr = only(
    [...module.functions]
      .filter(([, text]) =>
        /^\(func \$\S+ \(param \$0 i32\) \(result i32\) .*\(loop .*\(i32\.const 2147483647\)\).*\(i32\.load offset=24 /.test(
          flat(text),
        ),
      )
      .map(([name]) => name),
    'qstr_str',
  );
  module.functions.set(
    'is_own_name',
    `(func $is_own_name (param $name i32) (result i32) (local $text i32)
      (if (i32.eq (local.get $name) (i32.const ${dictionary})) (then (return (i32.const 1))))
      (local.set $text (call $${qstr} (local.get $name)))
      (i32.and
        (i32.eq (i32.load8_u (local.get $text)) (i32.const ${UNDERSCORE}))
        (i32.ne (i32.load8_u offset=1 (local.get $text)) (i32.const ${UNDERSCORE}))))`,
  );
  const text = flat(module.functions.get(attribute));
  const guard = `(if (i32.and
      (i32.and (i32.eqz (i32.load (local.get $2))) (global.get $in_program))
      (call $is_of_library (local.get $0)))
    (then (if (call $is_own_name (local.get $1)) (then (return)))))`;
  module.functions.set(attribute, `${text.slice(0, bodyStart(text))}${guard} ${text.slice(bodyStart(text))}`);
}

/** dir() and help() of what belongs to the library: of the names with underscores, `__class__` and `__name__` alone. */
function hideFromLists(module) {
  const qstr = onlyMatch(module.functions.get('is_own_name'), 'qstr_str', /\(call \$(\S+) \(local\.get \$name\)\)/)[1];
  module.functions.set('is_inside', isInside(qstr));
  module.functions.set(
    'is_of_library',
    `(func $is_of_library (param $at i32) (result i32)
      (i32.and
        (i32.ge_u (local.get $at) (global.get $heap_start))
        (i32.lt_u (local.get $at) (global.get $program_start))))`,
  );
  const dir = onlyFunction(
    module,
    'dir',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(result i32\) .*\(loop \$\S+ \(call \$\S+ \(i32\.load \(local\.get \$1\)\) \(local\.get \$0\) \(i32\.add \(local\.get \$2\) \(i32\.const 8\)\) \(i32\.const 0\)\) \(block (\$\S+) /,
  );
  replaceOnce(
    module,
    dir.name,
    'what a name stands for',
    new RegExp(`(\\(block \\${dir.match[1]} )(\\(br_if \\${dir.match[1]} \\(i32\\.eqz \\(i32\\.load offset=8)`),
    `$1(br_if ${doubled(dir.match[1])} (call $$is_inside (i32.load (local.get $$1)) (local.get $$0))) $2`,
  );
  const help = only(
    [...module.functions]
      .filter(([, text]) => flat(text).includes(`(i32.const ${addressOfText(module, ' is of type ')})`))
      .map(([name]) => name),
    'help',
  );
  replaceOnce(
    module,
    help,
    'a row of help()',
    /(\(block (\$\S+) \(block (\$\S+) \(br_table \2 \3 \3 \3 \2 \3 \(local\.tee (\$\d+) .*?\)\)\)\)\)\)\)\)) (\(local\.set \$\d+ \(i32\.load offset=4 )/,
    '$1 (br_if $2 (call $$is_inside (local.get $$asked) (i32.shr_u (local.get $4) (i32.const 3)))) $5',
  );
  const text = flat(module.functions.get(help));
  const keep = '(local $asked i32) (if (local.get $0) (then (local.set $asked (i32.load (local.get $1)))))';
  module.functions.set(help, `${text.slice(0, bodyStart(text))}${keep} ${text.slice(bodyStart(text))}`);
}

const doubled = (label) => label.replaceAll('$', '$$$$');

/** Whether a name of this object is not for a program: the object or its type is made by the library. */
const isInside = (qstr) => `(func $is_inside (param $object i32) (param $name i32) (result i32) (local $text i32)
  (local.set $text (call $${qstr} (local.get $name)))
  (if (i32.ne (i32.load8_u (local.get $text)) (i32.const ${UNDERSCORE})) (then (return (i32.const 0))))
  (if (i32.or
      (i32.eq (i32.load offset=2 align=1 (local.get $text)) (i32.const ${wordOf('clas')}))
      (i32.eq (i32.load offset=2 align=1 (local.get $text)) (i32.const ${wordOf('name')})))
    (then (return (i32.const 0))))
  (if (i32.and (local.get $object) (i32.const 3)) (then (return (i32.const 0))))
  (i32.or (call $is_of_library (local.get $object)) (call $is_of_library (i32.load (local.get $object)))))`;

/** Four letters as a word in memory. */
const wordOf = (letters) => new DataView(new TextEncoder().encode(letters).buffer).getUint32(0, true);
