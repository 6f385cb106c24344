// Boards have different versions of MicroPython: 1.18 on the micro:bit, 1.23 in newer firmware. The run-time side says
// which one; what differs asks for it here.

/** Declares the version: the number after "1.". */
export function declareVersion(module) {
  module.head += '\n (global $minor (mut i32) (i32.const 18))\n (export "minor" (global $minor))';
}

/** A WebAssembly expression: true if the board's MicroPython is older than 1.`minor`. */
export const olderThan = (minor) => `(i32.lt_s (global.get $minor) (i32.const ${minor}))`;
