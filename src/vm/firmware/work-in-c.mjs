// Work inside the C code takes simulated time that grows with the work, as on the board, and can be suspended there.
// Without it, sum(range(10**9)) would be over at once by the simulated clock and keep the computer busy for minutes.
//
// Nobody has measured these on a board. Each figure is an estimate from the C code, for a processor of 64 MHz that runs
// from flash memory; `SIXTEENTHS` are µs/16, about four cycles each.
import { addressOfText, expressionEnd, flat, only, onlyFunction, replaceOnce } from './wat.mjs';

const SIXTEENTHS = {
  /** One item for C code: mp_iternext saves registers for an exception, asks the iterator, and the caller uses the item
   *  (adds it, appends it, compares it). About 130 cycles. */
  item: 32,
  /** One comparison of a sort: mp_binary_op for two small numbers and the exchange. About 65 cycles. */
  comparison: 16,
  /** One place at which a text is looked for: a call of memcmp. About 20 cycles. */
  place: 5,
  /** One character at which str.count() looks, besides what goes on to the next one. About 30 cycles. */
  counted: 8,
  /** One text that is joined: its length is asked twice. About 40 cycles, besides the bytes. */
  joined: 10,
  /** One digit (16 bits) of a big number in one round of a loop of mpz.c. About 10 cycles. */
  digit: 3,
  /** One byte copied by newlib-nano's memcpy, which goes byte by byte. 4 cycles. */
  byte: 1,
  /** One character of a template of `%` or `format`: it is compared with the signs and added to a text that grows. About
   *  70 cycles. */
  template: 18,
  /** The digits of a decimal number (py/formatfloat.c): seven rounds of a comparison, a difference and a product, and
   *  about as many to bring it between 1 and 10, all in software. About 2,000 cycles. */
  decimal: 500,
  /** One block of 16 bytes in gc_collect(): its kind is read twice and written at most once in the sweep, and the C
   *  stack is looked through, about as long as a fourth of the sweep. About 20 cycles. */
  sweptBlock: 5,
  /** One block that lives: gc_mark_subtree checks its four words, and the kind of each that is a pointer. About 60
   *  cycles. */
  markedBlock: 15,
};

/**
 * Finds the places in the module as it was published. Their names stay when pointers are spilled; their shape does not.
 *
 * @returns the names of functions, for `chargeWork`
 */
export function findWork(module) {
  const iterate = only(
    functionsWith(module, addressOfText(module, "'%s' object isn't an iterator")).filter((name) =>
      // mp_iternext_allow_raise, which the `for` of Python uses, catches nothing.
      flat(module.functions.get(name)).includes('(i32.const 192)'),
    ),
    'mp_iternext',
  );
  const sort = onlyFunction(
    module,
    'mp_quicksort',
    /^\(func \$(\S+) (?:\(param \$\d i32\) ){4}\(local .*\(i32\.const 5\).*\(call \$\1 .*\(call \$\1 /,
  ).name;
  const find = onlyFunction(
    module,
    'find_subbytes',
    /^\(func \$\S+ (?:\(param \$\d i32\) ){5}\(result i32\) (?:\(local \$\d i32\) )*\(block \$\S+ \(block \$\S+ \(br_if \$\S+ \(i32\.lt_u \(local\.get \$1\) \(local\.get \$3\)\)\)/,
  ).name;
  const joining = 'join expects a list of str/bytes objects consistent with self object';
  const count = onlyFunction(
    module,
    'str.count',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(result i32\) .*\(i32\.ne \(local\.get \$\d+\) \(i32\.const \d+\)\)\) \(loop \$\S+ \(block \$\S+ \(block \$\S+ \(br_if \$\S+ \(call \$\S+ (?:\(local\.get \$\d+\) ?){3}\)\) \(local\.set \$0 \(i32\.add \(local\.get \$0\) \(i32\.const 1\)\)\)/,
  ).name;
  const compare = onlyFunction(
    module,
    'mp_seq_cmp_objs',
    /^\(func \$\S+ (?:\(param \$\d i32\) ){5}\(result i32\) .*\(loop \$\S+ \(br_if \$\S+ \(i32\.eqz \(call \$\S+ \(i32\.load /,
  ).name;
  const hash = onlyFunction(module, 'qstr_compute_hash', /^\(func \$\S+ .*\(local\.set \$2 \(i32\.const 5381\)\)/).name;
  const join = only(functionsWith(module, addressOfText(module, joining)), 'str.join');
  const templates = ["single '}' encountered in format string", 'incomplete format key'].map((text) =>
    addressOfText(module, text),
  );
  return {
    iterate,
    sort,
    find,
    count,
    compare,
    hash,
    join,
    templates,
    collect: askedCollection(module),
    bigNumbers: loopsOverDigits(module),
  };
}

const functionsWith = (module, address) =>
  [...module.functions].filter(([, text]) => flat(text).includes(`(i32.const ${address})`)).map(([name]) => name);

/**
 * modgc.c, gc.collect(). A collection that an allocation starts for want of memory has no charge of its own: what an
 * allocation costs was measured over a long loop, with the collections in it.
 */
function askedCollection(module) {
  const raiseFlag = onlyFunction(
    module,
    'gc_collect',
    /^\(func \$\S+ \(i32\.store8 offset=\d+ \(i32\.const 0\) \(i32\.const 1\)\)\)$/,
  ).name;
  return onlyFunction(
    module,
    'gc.collect',
    new RegExp(`^\\(func \\$\\S+ \\(result i32\\) \\(call \\$${raiseFlag}\\) \\(i32\\.const \\d+\\)\\)$`),
  ).name;
}

/** mpz.c: what the operators and the text of big numbers call, and what has loops over digits of 16 bits. */
function loopsOverDigits(module) {
  const operators = only(
    functionsWith(module, addressOfText(module, 'divide by zero')).filter(
      (name) =>
        functionsWith(module, addressOfText(module, 'negative shift count')).includes(name) &&
        // mp_binary_op has both texts, too, and the one that says that no number was given.
        !functionsWith(module, addressOfText(module, "unsupported types for %q: '%s', '%s'")).includes(name),
    ),
    'mp_obj_int_binary_op',
  );
  const found = new Set();
  const seen = new Set();
  const visit = (name) => {
    const text = flat(module.functions.get(name) ?? '');
    if (seen.has(name) || text === '') return;
    seen.add(name);
    const digits = /i32\.store16/.test(text) && /i32\.load16_u/.test(text) && /\(loop /.test(text);
    if (!digits && name !== operators) return;
    if (digits) found.add(name);
    for (const [, called] of text.matchAll(/\(call \$(\S+) /g)) visit(called);
  };
  visit(operators);
  const read = onlyFunction(
    module,
    'mpz_set_from_str',
    /^\(func \$\S+ (?:\(param \$\d i32\) ){5}\(result i32\)(?=.*\(i32\.const -55\))(?=.*\(i32\.const -87\))(?=.*\(i32\.store16 )/,
  ).name;
  const format = onlyFunction(
    module,
    'mpz_as_str_inpl',
    /^\(func \$\S+ (?:\(param \$\d i32\) ){6}\(result i32\)(?=.*\(memory\.copy )(?=.*\(loop )(?=.*\(i32\.load16_u )(?=.*\(i32\.store16 )/,
  ).name;
  return [...found, read, format];
}

/** The cost of the collection that has just ended, in sixteenths. */
const collection = `(i32.add
  (i32.mul (i32.const ${SIXTEENTHS.sweptBlock})
    (i32.shr_u (i32.sub (global.get $heap_end) (global.get $program_start)) (i32.const 4)))
  (i32.mul (i32.const ${SIXTEENTHS.markedBlock}) (call $used_blocks)))`;

/** Without suspending: an error's decimals are written when its program has ended, too. */
const decimal = `(if (global.get $in_program) (then
  (global.set $gas (i32.sub (global.get $gas) (i32.const ${SIXTEENTHS.decimal >> 4})))))`;

/**
 * The collections of gc_alloc that gc.threshold() asks for. Before pointers are spilled; without suspending in the middle of
 * an allocation.
 */
export function chargeThreshold(module, collect, allocate) {
  const name = 'collect_at_threshold';
  module.functions.set(
    name,
    `(func $${name}
      (call $${collect})
      (if (global.get $in_program) (then
        (global.set $gas (i32.sub (global.get $gas) (i32.shr_u ${collection} (i32.const 4)))))))`,
  );
  replaceOnce(
    module,
    allocate,
    'gc.threshold()',
    new RegExp(
      `(\\(br_if \\$\\S+ \\(i32\\.lt_u (?:\\(i32\\.load offset=\\d+ \\(i32\\.const \\d+\\)\\) ?){2}\\)\\)) \\(call \\$${collect}\\)`,
    ),
    `$1 (call $$${name})`,
  );
}

/** Adds the charges and the counter that they share. */
export function chargeWork(module, found) {
  const { iterate, sort, find, count, compare, hash, join, templates, collect, bigNumbers } = found;
  module.head += '\n (global $sixteenths (mut i32) (i32.const 0))';
  module.functions.set(
    'work',
    `(func $work (param $0 i32)
      (if (i32.eqz (global.get $in_program)) (then (return)))
      (global.set $sixteenths (i32.add (global.get $sixteenths) (local.get $0)))
      (if (i32.lt_u (global.get $sixteenths) (i32.const 16)) (then (return)))
      (global.set $gas (i32.sub (global.get $gas) (i32.shr_u (global.get $sixteenths) (i32.const 4))))
      (global.set $sixteenths (i32.and (global.get $sixteenths) (i32.const 15)))
      (if (i32.le_s (global.get $gas) (i32.const 0)) (then (call $tick))))`,
  );
  const change = (name, edit) => module.functions.set(name, edit(flat(module.functions.get(name))));
  const work = (sixteenths) => `(call $work (i32.const ${sixteenths}))`;
  const inEachLoop = (text, sixteenths) => text.replace(/\(loop \$\S+ /g, (loop) => loop + work(sixteenths) + ' ');
  change(iterate, (text) => atStart(text, work(SIXTEENTHS.item)));
  change(sort, (text) => inEachLoop(text, SIXTEENTHS.comparison));
  change(find, (text) => inEachLoop(text, SIXTEENTHS.place));
  change(count, (text) => inEachLoop(text, SIXTEENTHS.counted));
  change(compare, (text) => atStart(text, inWhole(SIXTEENTHS.comparison, '(local.get $2)')));
  change(hash, (text) => atStart(text, inWhole(SIXTEENTHS.byte, '(local.get $1)', 6)));
  change(join, (text) => inEachLoop(text, SIXTEENTHS.joined));
  // By what they say: one of them has got another name since.
  for (const address of templates)
    change(only(functionsWith(module, address), 'template'), (text) => inEachLoop(text, SIXTEENTHS.template));
  for (const [name, text] of module.functions)
    if (text.includes('(call $format_single')) change(name, (text) => atStart(text, decimal));
  change(collect, (text) => text.replace(/\(i32\.const \d+\)\)$/, (result) => `(call $work ${collection}) ${result}`));
  for (const name of bigNumbers) change(name, (text) => inEachLoop(text, SIXTEENTHS.digit));
  chargeCopies(module);
}

/**
 * A number of things in sixteenths, of which whole groups of 2 ** `bits` count: a few are part of what their bytecode
 * costs. Without suspending, as not all of it is Python's.
 */
const inWhole = (sixteenths, count, bits = 4) => `(if (global.get $in_program) (then
  (global.set $gas (i32.sub (global.get $gas)
    (i32.mul (i32.const ${sixteenths << (bits - 4)}) (i32.shr_u ${count} (i32.const ${bits})))))))`;

function atStart(text, instruction) {
  let place = text.indexOf(' ', '(func '.length) + 1;
  while (/^\((param|result|local|type) /.test(text.slice(place))) place = expressionEnd(text, place) + 1;
  return `${text.slice(0, place)}${instruction} ${text.slice(place)}`;
}

/** Slices, joined and repeated texts, lists that grow: all of them copy bytes. No suspending here: some of it is not Python's. */
function chargeCopies(module) {
  for (const [name, text] of module.functions)
    if (text.includes('(memory.copy'))
      module.functions.set(name, flat(text).replaceAll('(memory.copy ', '(call $copy '));
  module.functions.set(
    'copy',
    `(func $copy (param $0 i32) (param $1 i32) (param $2 i32)
      (if (global.get $in_program) (then
        (global.set $gas (i32.sub (global.get $gas) (i32.shr_u (i32.mul (local.get $2) (i32.const ${SIXTEENTHS.byte})) (i32.const 4))))))
      (memory.copy (local.get $0) (local.get $1) (local.get $2)))`,
  );
}
