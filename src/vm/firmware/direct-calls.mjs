// The interpreter of the published build calls nearly everything through the host, which catches what C's longjmp throws:
// a hundred ways there and back in one turn of a simple loop. What can neither raise nor wait is called directly here, and
// of some functions that nearly never do, the usual case is tried first. Results, time and memory stay what they are.
import { flat, only, onlyFunction, onlyMatch } from './wat.mjs';

/**
 * Comes before pointers are spilled, which brings the numbers of functions out of the calls. What is called instead has only the
 * long way yet.
 *
 * @returns what `shorten` takes
 */
export function callDirectly(module) {
  const table = functionTable(module);
  const direct = new Map(leaves(module, table));
  const isTrue = truth(module);
  const ofModule = globalName(module);
  const found = [
    isTrue,
    ofModule,
    localName(module, ofModule),
    unaryOperator(module, isTrue),
    binaryOperator(module),
    stackCheck(module),
  ];
  const shorter = found.map(({ name, parameters, result = ' (result i32)', quick }) => {
    const place = only(
      [...table].filter(([, each]) => each === name),
      `place of ${name} in the table`,
    )[0];
    direct.set(place, quickName(name));
    const given = parameters.map((each) => `(local.get ${each})`).join(' ');
    const long = `(call ${invoker(module, parameters.length, result)} (i32.const ${place}) ${given})`;
    const taken = parameters.map((each) => `(param ${each} i32)`).join(' ');
    const withBody = (body) => `(func $${quickName(name)} ${taken}${result} ${body})`;
    module.functions.set(quickName(name), withBody(long));
    return { name: quickName(name), text: withBody(quick(long)) };
  });
  const lookup = nameLookup(module);
  replaceCalls(module, direct);
  return { shorter, lookup };
}

/** Comes after pointers are spilled: the short ways allocate nothing and need no room on the stack, so they get none. */
export function shorten(module, { shorter, lookup }) {
  for (const { name, text } of shorter) module.functions.set(name, text);
  lookNamesUp(module, lookup);
}

const quickName = (name) => `quick_${name}`;

/** The functions that are called by their number, by that number. */
function functionTable(module) {
  const elements = /\(elem \$\S+ \(i32\.const (\d+)\)((?: \$\S+)+)\)/;
  const [, first, names] = onlyMatch(module.head, 'table of functions', elements);
  const all = names.trim().split(' ');
  return new Map(all.map((name, place) => [String(Number(first) + place), name.slice(1)]));
}

/** Functions that call nothing. */
function leaves(module, table) {
  const isLeaf = (name) => module.functions.has(name) && !/\(call(_indirect)? /.test(module.functions.get(name));
  return [...table].filter(([, name]) => isLeaf(name));
}

/** The host's function that calls one with so many parameters and such a result. */
function invoker(module, parameters, result) {
  const name = `invoke_${(result === '' ? 'v' : 'i') + 'i'.repeat(parameters)}`;
  return onlyMatch(module.head, name, new RegExp(`\\(import "env" "${name}" \\(func (\\$\\S+) `))[1];
}

function replaceCalls(module, direct) {
  const invokers = [...module.head.matchAll(/\(import "env" "invoke_\w+" \(func \$(\S+) /g)].map(([, name]) => name);
  const call = new RegExp(`\\(call \\$(?:${invokers.join('|').replaceAll('$', '\\$')}) \\(i32\\.const (\\d+)\\)`, 'g');
  let count = 0;
  for (const [name, text] of module.functions) {
    if (name.startsWith('quick_')) continue;
    const line = flat(text);
    const changed = line.replace(call, (whole, place) => {
      if (!direct.has(place)) return whole;
      count++;
      return `(call $${direct.get(place)}`;
    });
    if (changed !== line) module.functions.set(name, changed);
  }
  if (count < 20) throw new Error(`Direct calls: expected more than 20 places, found ${count}.`);
}

/** py/obj.c, mp_obj_is_true: None, False, True and small ints are decided from the value itself. */
function truth(module) {
  const { name, match } = onlyFunction(
    module,
    'mp_obj_is_true',
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) .*\(br_if \$block \(i32\.eq \(local\.get \$0\) \(i32\.const (\d+)\)\)\) \(br_if \$block \(i32\.eq \(local\.get \$0\) \(i32\.const (\d+)\)\)\) \(block \$block1 \(br_if \$block1 \(i32\.ne \(local\.get \$0\) \(i32\.const (\d+)\)\)\) \(return \(i32\.const 1\)\)\) \(block \$block2 \(br_if \$block2 \(i32\.eqz \(i32\.and \(local\.get \$0\) \(i32\.const 1\)\)\)\) \(return \(i32\.ne \(local\.get \$0\) \(i32\.const 1\)\)\)\)/,
  );
  const [none, no, yes] = match.slice(1);
  const is = (value) => `(i32.eq (local.get $0) (i32.const ${value}))`;
  const quick = (otherwise) => `(if (i32.or ${is(none)} ${is(no)}) (then (return (i32.const 0))))
    (if ${is(yes)} (then (return (i32.const 1))))
    (if (i32.and (local.get $0) (i32.const 1)) (then (return (i32.ne (local.get $0) (i32.const 1)))))
    ${otherwise}`;
  return { name, parameters: ['$0'], quick };
}

/** py/runtime.c, mp_load_global: a name among the module's own, or a built-in one. */
function globalName(module) {
  const { name, match } = onlyFunction(
    module,
    'mp_load_global',
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) .*\(br_if \$block \(local\.tee \$3 \(call \$\S+ \(i32\.add (\(i32\.load offset=\d+ \(i32\.const \d+\)\)) \(i32\.const 4\)\) \(local\.tee \$2 \(i32\.or \(i32\.shl \(local\.get \$0\) \(i32\.const 3\)\) \(i32\.const 2\)\)\) \(i32\.const 0\)\)\)\) \(block \$block1 \(br_if \$block1 \(i32\.eqz \(local\.tee \$3 (\(i32\.load offset=\d+ \(i32\.const \d+\)\))\)\)\).* \(call \$\S+ (\(i32\.add \(i32\.const \d+\) \(i32\.const 4\)\)) \(local\.get \$2\) \(i32\.const 0\)\)/,
  );
  const [, names, changedBuiltIns, builtIns] = match;
  const key = '(i32.or (i32.shl (local.get $0) (i32.const 3)) (i32.const 2))';
  const lookedUp = (map) => `(local.set $1 (call $${NAME_IN} ${map} ${key}))
    (if (i32.gt_s (local.get $1) (i32.const 0)) (then (return (i32.load offset=4 (local.get $1)))))`;
  const quick = (otherwise) => `(local $1 i32)
    ${lookedUp(`(i32.add ${names} (i32.const 4))`)}
    (if (i32.eqz (local.get $1)) (then
      (if ${changedBuiltIns} (then ${lookedUp(`(i32.add ${changedBuiltIns} (i32.const 4))`)}))
      (if (i32.eqz (local.get $1)) (then ${lookedUp(builtIns)}))))
    ${otherwise}`;
  return { name, parameters: ['$0'], quick };
}

/** py/runtime.c, mp_load_name: where the local names are the module's. */
function localName(module, ofModule) {
  const { name, match } = onlyFunction(
    module,
    'mp_load_name',
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) \(local \$1 i32\) \(block \$block \(br_if \$block (\(i32\.eq \(local\.tee \$1 \(i32\.load offset=\d+ \(i32\.const \d+\)\)\) \(i32\.load offset=\d+ \(i32\.const \d+\)\)\))\) /,
  );
  const quick = (otherwise) => `(local $1 i32)
    (if ${match[1]} (then (return (call $${quickName(ofModule.name)} (local.get $0)))))
    ${otherwise}`;
  return { name, parameters: ['$0'], quick };
}

/** py/runtime0.h: the operators of one small int, and the one int that has no negative. */
const PLUS = 0;
const MINUS = 1;
const INVERT = 2;
const LEAST = `(i32.const ${-(2 ** 31) + 1})`;

/** py/runtime.c, mp_unary_op: `not` is as quick as the truth; the sign and `~` of a small int. */
function unaryOperator(module, isTrue) {
  const { name, match } = onlyFunction(
    module,
    'mp_unary_op',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(result i32\) .*\(br_if \$block \(i32\.ne \(local\.get \$0\) \(i32\.const (\d+)\)\)\) \(local\.set \$3 \(select \(i32\.const (\d+)\) \(i32\.const (\d+)\) \(call \$\S+ \(local\.get \$1\)\)\)\) \(br \$block1\)/,
  );
  const [, operator, no, yes] = match;
  const is = (each) => `(i32.eq (local.get $0) (i32.const ${each}))`;
  const quick = (otherwise) => `(if ${is(operator)} (then
      (return (select (i32.const ${no}) (i32.const ${yes}) (call $${quickName(isTrue.name)} (local.get $1))))))
    (if (i32.and (local.get $1) (i32.const 1)) (then
      (if ${is(PLUS)} (then (return (local.get $1))))
      (if (i32.and ${is(MINUS)} (i32.ne (local.get $1) ${LEAST})) (then (return (i32.sub (i32.const 2) (local.get $1)))))
      (if ${is(INVERT)} (then (return (i32.xor (local.get $1) (i32.const -2)))))))
    ${otherwise}`;
  return { name, parameters: ['$0', '$1'], quick };
}

/** py/stackctrl.c, mp_stack_check: raises where the C stack is used up, and does nothing elsewhere. */
function stackCheck(module) {
  const { name, match } = onlyFunction(
    module,
    'mp_stack_check',
    /^\(func \$\S+ \(local \$0 i32\) \(global\.set \$__stack_pointer \(local\.tee \$0 \(i32\.sub \(global\.get \$__stack_pointer\) \(i32\.const (\d+)\)\)\)\) \(block \$block \(br_if \$block (\(i32\.lt_u \(i32\.sub \(i32\.load offset=\d+ \(i32\.const \d+\)\) \(i32\.add \(local\.get \$0\) \(i32\.const \d+\)\)\) \(i32\.load offset=\d+ \(i32\.const \d+\)\)\))\)/,
  );
  const [, frame, isEnough] = match;
  const quick = (otherwise) => `(local $0 i32)
    (local.set $0 (i32.sub (global.get $__stack_pointer) (i32.const ${frame})))
    (if (i32.eqz ${isEnough}) (then ${otherwise}))`;
  return { name, parameters: [], quick, result: '' };
}

/** py/runtime0.h: the operators that small ints take most often, and `is`. */
const IS = 7;
const COMPARED = { 0: 'lt_s', 1: 'gt_s', 2: 'eq', 3: 'le_s', 4: 'ge_s', 5: 'ne' };
const SUMS = { add: [14, 27], sub: [15, 28] }; // += and +, -= and -
const BITWISE = { or: [9, 22], and: [11, 24] }; // |= and |, &= and &
const PRODUCT = [16, 29]; // *= and *
const SHIFT_RIGHT = [13, 26]; // >>= and >>

/** py/runtime.c, mp_binary_op: of two small ints whose result is a bool or a small int, too; and `is` of any two. */
function binaryOperator(module) {
  const { name, match } = onlyFunction(
    module,
    'mp_binary_op',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) \(result i32\) .*\(br_table (?:\$\S+ ){8}\(i32\.add \(local\.get \$0\) \(i32\.const -2\)\)\)\) .*\(local\.set \$4 \(select \(i32\.const (\d+)\) \(i32\.const (\d+)\) \(call \$\S+ \(local\.get \$1\) \(local\.get \$2\)\)\)\)/,
  );
  const [, yes, no] = match;
  const isAny = (operators) =>
    operators
      .map((each) => `(i32.eq (local.get $0) (i32.const ${each}))`)
      .reduce((all, one) => `(i32.or ${all} ${one})`);
  const compared = Object.entries(COMPARED).map(
    ([operator, test]) => `(if ${isAny([operator])} (then
      (return (select (i32.const ${yes}) (i32.const ${no}) (i32.${test} (local.get $1) (local.get $2))))))`,
  );
  // A small int is twice its value and one: what does not fit has another sign or half when it is doubled.
  const whole = (side) => `(i32.shr_s (local.get ${side}) (i32.const 1))`;
  const sums = Object.entries(SUMS).map(
    ([sum, operators]) => `(if ${isAny(operators)} (then
      (local.set $3 (i32.${sum} ${whole('$1')} ${whole('$2')}))
      (if (i32.eq (i32.shr_s (i32.shl (local.get $3) (i32.const 1)) (i32.const 1)) (local.get $3)) (then
        (return (i32.or (i32.shl (local.get $3) (i32.const 1)) (i32.const 1)))))))`,
  );
  // The last bit of both is 1, and stays so.
  const bitwise = Object.entries(BITWISE).map(
    ([each, operators]) => `(if ${isAny(operators)} (then (return (i32.${each} (local.get $1) (local.get $2)))))`,
  );
  const wide = (side) => `(i64.extend_i32_s ${whole(side)})`;
  const product = `(if ${isAny(PRODUCT)} (then
      (local.set $4 (i64.mul ${wide('$1')} ${wide('$2')}))
      (local.set $3 (i32.wrap_i64 (local.get $4)))
      (if (i64.eq (i64.extend_i32_s (i32.shr_s (i32.shl (local.get $3) (i32.const 1)) (i32.const 1))) (local.get $4)) (then
        (return (i32.or (i32.shl (local.get $3) (i32.const 1)) (i32.const 1)))))))`;
  const shifted = `(if ${isAny(SHIFT_RIGHT)} (then
      (if (i32.lt_u ${whole('$2')} (i32.const 31)) (then
        (return (i32.or (i32.shl (i32.shr_s ${whole('$1')} ${whole('$2')}) (i32.const 1)) (i32.const 1)))))))`;
  const quick = (otherwise) => `(local $3 i32) (local $4 i64)
    (if ${isAny([IS])} (then
      (return (select (i32.const ${yes}) (i32.const ${no}) (i32.eq (local.get $1) (local.get $2))))))
    (if (i32.and (i32.and (local.get $1) (local.get $2)) (i32.const 1)) (then
      ${[...compared, ...sums, ...bitwise, product, shifted].join('\n')}))
    ${otherwise}`;
  return { name, parameters: ['$0', '$1', '$2'], quick };
}

/** The function that looks a name up among names, see `lookNamesUp`. */
const NAME_IN = 'name_in';

/** py/map.c, mp_map_lookup. */
function nameLookup(module) {
  const { name, match } = onlyFunction(
    module,
    'mp_map_lookup',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) \(result i32\) .*\(i32\.load8_u (offset=\d+) (\(i32\.add \(i32\.const \d+\) \(i32\.and \(i32\.shr_u \(local\.get \$1\) \(i32\.const 2\)\) \(i32\.const \d+\)\)\))\).*\(local\.set \$8 \(call (\$\S+) \(i32\.shr_u \(local\.get \$1\) \(i32\.const 3\)\)\)\)/,
  );
  const [, offset, cached, hashOf] = match;
  return { name, offset, cached, hashOf };
}

/**
 * A name among names is compared as a number. The whole lookup may call a program's `__eq__`, which makes it suspendable, and
 * slow for that. The short one gives the place of the key and its value, 0 where there is none, and -1 where the whole one has
 * to look: for what is no name, or not only among names.
 */
function lookNamesUp(module, { name, offset, cached, hashOf }) {
  for (const [each, text] of module.functions)
    module.functions.set(each, flat(text).replaceAll(`(call $${name} `, `(call $${quickName(name)} `));
  module.functions.set(
    quickName(name),
    `(func $${quickName(name)} (param $0 i32) (param $1 i32) (param $2 i32) (result i32) (local $3 i32)
      (if (i32.eqz (local.get $2)) (then
        (local.set $3 (call $${NAME_IN} (local.get $0) (local.get $1)))
        (if (i32.ge_s (local.get $3) (i32.const 0)) (then (return (local.get $3))))))
      (call $${name} (local.get $0) (local.get $1) (local.get $2)))`,
  );
  const table = '(i32.load offset=8 (local.get $0))';
  const bits = (mask) => `(i32.and (i32.load (local.get $0)) (i32.const ${mask}))`; // names alone 1, in order 4, count << 3
  const slotAt = (place) => `(i32.add ${table} (i32.shl ${place} (i32.const 3)))`;
  const isFound = '(i32.eq (i32.load (local.get $slot)) (local.get $1))';
  const found = (place) => `(i32.store8 ${offset} ${cached} ${place}) (return (local.get $slot))`;
  module.functions.set(
    NAME_IN,
    `(func $${NAME_IN} (param $0 i32) (param $1 i32) (result i32)
      (local $slots i32) (local $slot i32) (local $place i32) (local $first i32) (local $end i32)
      (if (i32.ne (i32.and (local.get $1) (i32.const 7)) (i32.const 2)) (then (return (i32.const -1))))
      (if (i32.eqz ${bits(1)}) (then (return (i32.const -1))))
      (local.set $slots (i32.load offset=4 (local.get $0)))
      (if (i32.eqz (local.get $slots)) (then (return (i32.const 0))))
      (local.set $slot ${slotAt(`(i32.rem_u (i32.load8_u ${offset} ${cached}) (local.get $slots))`)})
      (if ${isFound} (then (return (local.get $slot))))
      (if ${bits(4)} (then
        (local.set $slot ${table})
        (local.set $end (i32.add (local.get $slot) ${bits(-8)}))
        (loop $next
          (if (i32.ge_u (local.get $slot) (local.get $end)) (then (return (i32.const 0))))
          (if ${isFound} (then ${found(`(i32.shr_u (i32.sub (local.get $slot) ${table}) (i32.const 3))`)}))
          (local.set $slot (i32.add (local.get $slot) (i32.const 8)))
          (br $next))))
      (local.set $first (i32.rem_u (call ${hashOf} (i32.shr_u (local.get $1) (i32.const 3))) (local.get $slots)))
      (local.set $place (local.get $first))
      (loop $next
        (local.set $slot ${slotAt('(local.get $place)')})
        (if (i32.eqz (i32.load (local.get $slot))) (then (return (i32.const 0))))
        (if ${isFound} (then ${found('(local.get $place)')}))
        (local.set $place (i32.add (local.get $place) (i32.const 1)))
        (if (i32.eq (local.get $place) (local.get $slots)) (then (local.set $place (i32.const 0))))
        (br_if $next (i32.ne (local.get $place) (local.get $first))))
      (i32.const 0))`,
  );
}
