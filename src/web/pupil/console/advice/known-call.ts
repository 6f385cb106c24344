import { parametersOf } from '#reference/arguments';
import type { Reader } from '#reference/reader';
import { argumentsOf } from '#python/expressions';
import { textOf, type PythonText, type SyntaxNode } from '#python/tree';

/** A call of a function with one known signature; `null` for any other. */
export function knownCall(program: PythonText, reader: Reader, call: SyntaxNode) {
  const callee = call.firstChild;
  if (callee === null) return null;
  const item = reader.evaluate(callee, reader.scopeAt(callee.from))?.item;
  const [only] = item?.calls ?? [];
  if (only === undefined || item?.calls.length !== 1) return null;
  const parameters = parametersOf(only);
  const given = argumentsOf(program, call).length;
  const required = parameters.filter(({ text, rest, byName }) => !text.includes('=') && !rest && !byName).length;
  const most = parameters.some(({ rest }) => rest) ? Infinity : parameters.length;
  const takes = (count: number): boolean => count >= required && count <= most;
  const name = textOf(program, callee);
  return { node: call, callee, item, name, given, parameters, takes, fits: takes(given) };
}
