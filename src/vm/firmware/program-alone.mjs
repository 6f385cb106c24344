// A collection goes through the program's part of the heap alone. Nothing of our library below it is ever freed, so its
// blocks need no marks and no sweep: they are only looked through for what they hold of the program's. That makes a
// collection several times shorter, and it is most of the time of a program that makes many small objects.
import { bodyStart, expressionEnd, flat, only, onlyFunction, onlyMatch, replaceOnce } from './wat.mjs';

/** py/mpstate.h, mp_state_mem_area_t: where its fields are. */
const Area = { table: 4, tableBytes: 8, finalisers: 12, pool: 16, lastFree: 24, lastUsed: 28 };

/** Call it once gc_collect() marks at once, gc_init() reports where the heap lies, and the reserve is freed. */
export function collectProgramAlone(module) {
  const area = evenTables(module);
  const collect = onlyFunction(module, 'gc_collect', /\(call \$collected\)/).name;
  const text = flat(module.functions.get(collect));
  const start = text.slice(bodyStart(text)).match(/^\(call \$(\S+)\)/)[1];
  const mark = only([...new Set(marksIn(module, start))], 'gc_mark_subtree');
  module.head += `
 (global $library_end (mut i32) (i32.const 0))
 (export "library_end" (global $library_end))`;
  module.functions.set('shift_heap', shiftHeap(area));
  module.functions.set('narrow_heap', narrowHeap(area));
  module.functions.set('mark_from_library', markFromLibrary(area, mark));
  module.functions.set('used_blocks', usedBlocks(area));
  keepLibraryWhole(module, area);
  const narrowed = `(local.set $shift (call $narrow_heap)) ${text.slice(bodyStart(text))}`.replace(
    /\(call \$(\S+)\) \(call \$collected\)/,
    (_, end) =>
      [
        '(if (local.get $shift) (then (call $mark_from_library (local.get $shift))))',
        `(call $${end})`,
        '(call $shift_heap (i32.sub (i32.const 0) (local.get $shift)))',
        '(call $collected)',
      ].join(' '),
  );
  module.functions.set(collect, `${text.slice(0, bodyStart(text))}(local $shift i32) ${narrowed}`);
}

/**
 * Blocks that the library gives back itself (the table of a dictionary that has grown) are not freed: a program's object must
 * not come to lie there. It is emptied, so that it holds nothing.
 */
function keepLibraryWhole(module, area) {
  const free = onlyFunction(module, 'm_malloc_fail', /\(call \$(\S+) \(global\.get \$reserve\)\)/).match[1];
  const text = flat(module.functions.get(free));
  const isOurs = `(i32.and
    (i32.ne (global.get $library_end) (i32.const 0))
    (i32.lt_u (local.get $0) (global.get $program_start)))`;
  const guard = `(if ${isOurs} (then (if (local.get $0) (then (call $empty_in_library (local.get $0)))) (return)))`;
  module.functions.set(free, `${text.slice(0, bodyStart(text))}${guard} ${text.slice(bodyStart(text))}`);
  module.functions.set(
    'empty_in_library',
    `(func $empty_in_library (param $at i32) (local $block i32) (local $first i32)
      (local.set $first (local.tee $block (i32.shr_u
        (i32.sub (local.get $at) (i32.load (i32.const ${area + Area.pool})))
        (i32.const 4))))
      (loop $next
        (local.set $block (i32.add (local.get $block) (i32.const 1)))
        (br_if $next (i32.eq
          (i32.and
            (i32.shr_u
              (i32.load8_u (i32.add
                (i32.load (i32.const ${area + Area.table}))
                (i32.shr_u (local.get $block) (i32.const 2))))
              (i32.shl (i32.and (local.get $block) (i32.const 3)) (i32.const 1)))
            (i32.const 3))
          (i32.const 2))))
      (memory.fill
        (local.get $at)
        (i32.const 0)
        (i32.shl (i32.sub (local.get $block) (local.get $first)) (i32.const 4))))`,
  );
}

const marksIn = (module, start) =>
  [
    ...flat(module.functions.get(start)).matchAll(
      /\(call \$(\S+) \(local\.get \$\d+\) \(i32\.shr_u \(local\.get \$\d+\) \(i32\.const 4\)\)\)/g,
    ),
  ].map((match) => match[1]);

/**
 * Makes the table of kinds an even number of bytes: then the program's part can begin at a byte of both tables (four
 * blocks in a byte of kinds, eight in a byte of finalisers).
 *
 * @returns the address of the heap's area
 */
function evenTables(module) {
  const init = onlyFunction(module, 'gc_init', /\(global\.set \$heap_start /).name;
  const text = flat(module.functions.get(init));
  const address = (match) => Number(match[1]) + Number(match[2]);
  const table = onlyMatch(
    text,
    'table of kinds',
    /\(i32\.store offset=(\d+) \(i32\.const (\d+)\) \(local\.get \$0\)\)/,
  );
  const pool = onlyMatch(text, 'pool', /\(i32\.store offset=(\d+) \(i32\.const (\d+)\) \(i32\.sub /);
  const area = address(table) - Area.table;
  if (address(pool) !== area + Area.pool) throw new Error('The fields of the heap have moved.');
  const place = onlyMatch(text, 'size of the table', /\(i32\.div_u /).index;
  const size = text.slice(place, expressionEnd(text, place));
  replaceOnce(
    module,
    init,
    'size of the table',
    /\(i32\.div_u .*?\(i32\.const 524\)\)/,
    `(i32.and ${size} (i32.const -2))`,
  );
  return area;
}

/** Moves the start of the heap, with its tables, by so many blocks (a multiple of eight). */
const shiftHeap = (area) => {
  const load = (field) => `(i32.load (i32.const ${area + field}))`;
  const add = (field, blocks) => `(i32.store (i32.const ${area + field}) (i32.add ${load(field)} ${blocks}))`;
  const shifted = (by) => `(i32.shr_s (local.get $blocks) (i32.const ${by}))`;
  const taken = (blocks) => `(i32.sub (i32.const 0) ${blocks})`;
  return `(func $shift_heap (param $blocks i32)
    ${add(Area.table, shifted(2))}
    ${add(Area.tableBytes, taken(shifted(2)))}
    ${add(Area.finalisers, shifted(3))}
    ${add(Area.pool, '(i32.shl (local.get $blocks) (i32.const 4))')}
    ${add(Area.lastUsed, taken('(local.get $blocks)'))}
    (if (i32.lt_s (local.get $blocks) (i32.const 0))
      (then ${add(Area.lastFree, taken(shifted(2)))})))`;
};

/** Once the library is complete: leaves the program's part of the heap. Returns how many blocks lie before it. */
const narrowHeap = (area) => `(func $narrow_heap (result i32) (local $blocks i32)
  (if (i32.eqz (global.get $library_end)) (then (return (i32.const 0))))
  (local.set $blocks (i32.shr_u
    (i32.sub (global.get $program_start) (i32.load (i32.const ${area + Area.pool})))
    (i32.const 4)))
  (if (i32.lt_u (i32.load (i32.const ${area + Area.lastUsed})) (local.get $blocks))
    (then (i32.store (i32.const ${area + Area.lastUsed}) (local.get $blocks))))
  (call $shift_heap (local.get $blocks))
  (local.get $blocks))`;

/** How many blocks of the program's part are in use. */
const usedBlocks = (area) => `(func $used_blocks (result i32)
  (local $at i32) (local $end i32) (local $kinds i32) (local $used i32)
  (local.set $at (i32.add
    (i32.load (i32.const ${area + Area.table}))
    (i32.shr_u
      (i32.sub (global.get $program_start) (i32.load (i32.const ${area + Area.pool})))
      (i32.const 6))))
  (local.set $end (i32.add
    (local.get $at)
    (i32.shr_u (i32.sub (global.get $heap_end) (global.get $program_start)) (i32.const 6))))
  (loop $next
    (local.set $kinds (i32.load8_u (local.get $at)))
    (local.set $used (i32.add (local.get $used) (i32.popcnt (i32.and
      (i32.or (local.get $kinds) (i32.shr_u (local.get $kinds) (i32.const 1)))
      (i32.const 0x55)))))
    (br_if $next (i32.lt_u
      (local.tee $at (i32.add (local.get $at) (i32.const 1)))
      (local.get $end))))
  (local.get $used))`;

/** Marks the blocks of the program's part that words of the library point to. */
const markFromLibrary = (area, mark) => `(func $mark_from_library (param $blocks i32)
  (local $at i32) (local $place i32) (local $kinds i32) (local $block i32)
  (local.set $at (i32.sub (global.get $program_start) (i32.shl (local.get $blocks) (i32.const 4))))
  (loop $next
    (local.set $place (i32.sub (i32.load (local.get $at)) (global.get $program_start)))
    (block $other
      (br_if $other (i32.ge_u (local.get $place) (i32.sub (global.get $heap_end) (global.get $program_start))))
      (br_if $other (i32.and (local.get $place) (i32.const 15)))
      (local.set $block (i32.shr_u (local.get $place) (i32.const 4)))
      (local.set $kinds (i32.add
        (i32.load (i32.const ${area + Area.table}))
        (i32.shr_u (local.get $block) (i32.const 2))))
      (local.set $place (i32.shl (i32.and (local.get $block) (i32.const 3)) (i32.const 1)))
      (br_if $other (i32.ne
        (i32.and (i32.shr_u (i32.load8_u (local.get $kinds)) (local.get $place)) (i32.const 3))
        (i32.const 1)))
      (i32.store8 (local.get $kinds) (i32.or
        (i32.load8_u (local.get $kinds))
        (i32.shl (i32.const 3) (local.get $place))))
      (call $${mark} (i32.const ${area}) (local.get $block)))
    (br_if $next (i32.lt_u
      (local.tee $at (i32.add (local.get $at) (i32.const 4)))
      (global.get $library_end)))))`;
