import { bodyStart, flat, onlyFunction, onlyMatch } from './wat.mjs';

/**
 * A program that is pasted into the REPL prints the values of its expressions. The built-in compile() does so only for
 * single statements; here `echo` switches it on for everything that is compiled: mp_parse_compile_execute calls
 * mp_compile, which calls mp_compile_to_raw_code, whose third parameter is is_repl.
 */
export function echoPasted(module) {
  const execute = onlyFunction(
    module,
    'mp_parse_compile_execute',
    /\(call \$(\S+) \(i32\.add \(local\.get \$\d+\) \(i32\.const 8\)\) \(local\.get \$2\) \(i32\.eqz \(local\.get \$1\)\)\)/,
  );
  const compile = onlyMatch(
    flat(module.functions.get(execute.match[1])),
    'mp_compile_to_raw_code',
    /\(call \$(\S+) \(local\.get \$0\) \(local\.get \$1\) \(local\.get \$2\) \(i32\.add/,
  )[1];
  const text = flat(module.functions.get(compile));
  const body = bodyStart(text);
  const echo = '(local.set $2 (i32.or (local.get $2) (global.get $echo)))';
  module.functions.set(compile, `${text.slice(0, body)}${echo} ${text.slice(body)}`);
}
