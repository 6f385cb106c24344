// The interpreter of the published build calls nearly everything through the host, which catches what C's longjmp throws:
// a hundred ways there and back in one turn of a simple loop. What can neither raise nor wait is called directly here, and
// of three functions that nearly never do, the usual case is tried first. Results, time and memory stay what they are.
import { flat, only, onlyFunction, onlyMatch } from './wat.mjs';

export function callDirectly(module) {
  const table = functionTable(module);
  const direct = new Map(leaves(module, table));
  const shorten = (name, [parameters, quick]) => {
    const place = only(
      [...table].filter(([, each]) => each === name),
      `place of ${name} in the table`,
    )[0];
    const given = parameters.map((each) => `(local.get ${each})`).join(' ');
    const otherwise = `(call ${invoker(module, parameters.length)} (i32.const ${place}) ${given})`;
    const taken = parameters.map((each) => `(param ${each} i32)`).join(' ');
    module.functions.set(`quick_${name}`, `(func $quick_${name} ${taken} (result i32) ${quick(otherwise)})`);
    direct.set(place, `quick_${name}`);
  };
  shorten(...truth(module));
  shorten(...globalName(module));
  shorten(...binaryOperator(module));
  replaceCalls(module, direct);
}

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

/** The host's function that calls one with so many parameters and a result. */
function invoker(module, parameters) {
  const name = `invoke_${'i'.repeat(parameters + 1)}`;
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
  return [
    name,
    [
      ['$0'],
      (otherwise) => `(if (i32.or ${is(none)} ${is(no)}) (then (return (i32.const 0))))
        (if ${is(yes)} (then (return (i32.const 1))))
        (if (i32.and (local.get $0) (i32.const 1)) (then (return (i32.ne (local.get $0) (i32.const 1)))))
        ${otherwise}`,
    ],
  ];
}

/** py/runtime.c, mp_load_global: a name among the module's own, as long as all its keys are names. */
function globalName(module) {
  const { name, match } = onlyFunction(
    module,
    'mp_load_global',
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) .*\(br_if \$block \(local\.tee \$3 \(call (\$\S+) \(i32\.add (\(i32\.load offset=\d+ \(i32\.const \d+\)\)) \(i32\.const 4\)\) \(local\.tee \$2 \(i32\.or \(i32\.shl \(local\.get \$0\) \(i32\.const 3\)\) \(i32\.const 2\)\)\) \(i32\.const 0\)\)\)\) \(block \$block1/,
  );
  const [, lookUp, names] = match;
  const key = '(i32.or (i32.shl (local.get $0) (i32.const 3)) (i32.const 2))';
  return [
    name,
    [
      ['$0'],
      (otherwise) => `(local $1 i32)
        (local.set $1 (i32.add ${names} (i32.const 4)))
        (if (i32.and (i32.load (local.get $1)) (i32.const 1)) (then
          (local.set $1 (call ${lookUp} (local.get $1) ${key} (i32.const 0)))
          (if (local.get $1) (then (return (i32.load offset=4 (local.get $1)))))))
        ${otherwise}`,
    ],
  ];
}

/** py/runtime0.h: the operators that small ints take most often. */
const COMPARED = { 0: 'lt_s', 1: 'gt_s', 2: 'eq', 3: 'le_s', 4: 'ge_s', 5: 'ne' };
const SUMS = { add: [14, 27], sub: [15, 28] }; // += and +, -= and -

/** py/runtime.c, mp_binary_op: of two small ints whose result is a bool or a small int, too. */
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
  return [
    name,
    [
      ['$0', '$1', '$2'],
      (otherwise) => `(local $3 i32)
        (if (i32.and (i32.and (local.get $1) (local.get $2)) (i32.const 1)) (then
          ${compared.join('\n')}
          ${sums.join('\n')}))
        ${otherwise}`,
    ],
  ];
}
