// Errors of Python are caught inside the firmware. The published build was made for engines without exceptions: from a
// function that may catch something, every call goes through a function of the host, which calls back and catches what
// C's longjmp throws. The interpreter is such a function, so that was two changes of side for most bytecodes. Engines
// have had exceptions since 2022 (Chrome 95, Firefox 100, Safari 15.2).
import binaryen from 'binaryen';

const { i32, none } = binaryen;
const TAG = 'longjmp';
/** asyncify: the frames of a suspended program are being entered again. */
const REWINDING = 2;
/** Call it last: what suspends programs cannot go through functions that catch. */
export function catchInside(module) {
  module.setFeatures(module.getFeatures() | binaryen.Features.ExceptionHandling);
  module.addTag(TAG, none, none);
  module.addGlobal('catch_level', i32, true, module.i32.const(0));
  module.addGlobal('catch_levels', i32, true, module.i32.const(0));
  module.addGlobalExport('catch_levels', 'catch_levels');
  addCaught(module);
  for (const { name, base, params, results } of imports(module)) {
    if (base === '_emscripten_throw_longjmp') {
      module.removeFunction(name);
      module.addFunction(name, none, none, [], module.throw(TAG, []));
    } else if (base.startsWith('invoke_')) {
      module.removeFunction(name);
      addInvoke(module, name, params, results);
    }
  }
}

const imports = (module) =>
  Array.from({ length: module.getNumFunctions() }, (_, index) =>
    binaryen.getFunctionInfo(module.getFunctionByIndex(index)),
  ).filter((info) => info.module === 'env');

const stackPointer = (module) => module.global.get('__stack_pointer', i32);

/** Where the word of a level is: the stack pointer with which it was entered. */
const place = (module, level) =>
  module.i32.add(
    module.global.get('catch_levels', i32),
    module.i32.shl(module.local.get(level, i32), module.i32.const(2)),
  );

/**
 * Back at a level. Remains of frames in the C stack would keep dead objects alive: later frames cover them without
 * filling them, and the collector takes any word there for a pointer.
 */
function addCaught(module) {
  const setThrew = binaryen.getExportInfo(module.getExport('setThrew')).value;
  const [level, before] = [0, 1];
  const body = module.block(null, [
    module.local.set(before, module.i32.load(0, 4, place(module, level))),
    module.memory.fill(
      stackPointer(module),
      module.i32.const(0),
      module.i32.sub(module.local.get(before, i32), stackPointer(module)),
    ),
    module.global.set('__stack_pointer', module.local.get(before, i32)),
    module.call(setThrew, [module.i32.const(1), module.i32.const(0)], none),
  ]);
  module.addFunction('caught', i32, none, [i32], body);
}

/**
 * Calls a function of the table, and catches what it throws. When a suspended call is resumed, the stack pointer is
 * already at the deep place. So the one on entry is kept for each level; otherwise each exception that is caught after a
 * suspension would leak C stack.
 */
function addInvoke(module, name, params, results) {
  const types = binaryen.expandType(params);
  const given = types.map((type, index) => module.local.get(index, type));
  const [level, result] = [types.length, types.length + 1];
  const isRewinding = module.i32.eq(module.global.get('__asyncify_state', i32), module.i32.const(REWINDING));
  const call = module.call_indirect('0', given[0], given.slice(1), binaryen.createType(types.slice(1)), results);
  const body = [
    module.local.set(level, module.global.get('catch_level', i32)),
    module.if(module.i32.eqz(isRewinding), module.i32.store(0, 4, place(module, level), stackPointer(module))),
    module.global.set('catch_level', module.i32.add(module.local.get(level, i32), module.i32.const(1))),
    module.try(
      '',
      results === none ? call : module.local.set(result, call),
      [TAG],
      [module.call('caught', [module.local.get(level, i32)], none)],
    ),
    module.global.set('catch_level', module.local.get(level, i32)),
  ];
  if (results !== none) body.push(module.local.get(result, results));
  module.addFunction(name, params, results, [i32, i32], module.block(null, body, results));
}
