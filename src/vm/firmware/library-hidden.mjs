// The device's modules are C code: a program sees their public names and no more. Ours are Python, and what they are made
// of (the simulation's functions, other parts of the library) would be in reach as `music._hal` or
// `type(display).scroll.__globals__`. Here a program finds neither; the library itself does.
import { bodyStart, flat, only, onlyFunction, onlyMatch } from './wat.mjs';

const UNDERSCORE = '_'.charCodeAt(0);

/** Call it while functions have the shape in which they were published. */
export function hideLibrary(module) {
  hideInsidesOfFunctions(module);
  hideOwnNames(module);
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
      (i32.and (i32.ge_u (local.get $0) (global.get $heap_start)) (i32.lt_u (local.get $0) (global.get $program_start))))
    (then (if (call $is_own_name (local.get $1)) (then (return)))))`;
  module.functions.set(attribute, `${text.slice(0, bodyStart(text))}${guard} ${text.slice(bodyStart(text))}`);
}
