import { Reference } from '#reference/meaning';
import { Reader } from '#reference/reader';
import { namesOf } from '#python/scopes';
import { readPython, textOf, type PythonText, type SyntaxNode } from '#python/tree';

import { contextOf, type Written } from '../../../session/work/hardware/written-for';
import { meantName } from './did-you-mean';
import { decimalComma, type DecimalComma } from './decimal-comma';
import type { Failure } from './error-advice';
import { importLine, withImport } from './import-line';
import { knownCall } from './known-call';
import { robotModules } from './robot-modules';
import { missingName, placesOf } from '#advice/missing-name';
import { withMend, type Source, type SyntaxAdvice } from '#advice/syntax-advice';

/** Advice on an error with the help of the reference: a better sentence, or the name that was meant. */
export interface LateAdvice {
  readonly advice: SyntaxAdvice | null;
  readonly meant: string | null;
  readonly mend: SyntaxAdvice['mend'];
}

/** Looks an error up in the reference of the chosen board and robot. In doubt it finds nothing. */
export function lateAdvice(failure: Failure, source: Source, written: Written): LateAdvice {
  const name = unknownName(failure);
  const advice = name === null ? callAdvice(failure, source, written) : nameLate(name, source, written);
  if (advice !== null) return { advice, meant: null, mend: advice.mend };
  const meant = meantName(failure, source, written);
  if (meant === null) return { advice: null, meant, mend: undefined };
  // With the right name at hand, the way to look for it is not said.
  const short: SyntaxAdvice | null = name === null ? null : { key: 'error.unknownName', values: { name } };
  return { advice: short, meant, mend: renamed(failure, meant, source) };
}

const unknownName = (failure: Failure): string | null => (failure.type === 'NameError' ? missingName(failure) : null);

/** Advice on a name that a module has, or that the program has elsewhere; `null`: none. */
function nameLate(name: string, source: Source, written: Written): SyntaxAdvice | null {
  const program = readPython(source.text);
  const { bindings, root } = namesOf(program);
  if (bindings.has(name)) {
    const later = root.names.find((it) => it.name === name);
    if (later === undefined) return root.inner.length === 0 ? null : { key: 'error.onlyInside', values: { name } };
    const line = source.text.slice(0, later.at).split('\n').length;
    const failing = source.text.split('\n')[source.line - 1] ?? '';
    const isTop = /^\S/.test(failing) && !/^(?:for|while|if|elif|else|try|except|with)\b/.test(failing);
    return isTop && line > source.line ? { key: 'error.definedLater', values: { name, line } } : null;
  }
  const found = importLine(name, new Reference(contextOf(written)), robotModules(written));
  if (found === null) return null;
  const imported = namesOf(program).imports.filter(({ module }) => module === found.module);
  if (imported.some(({ symbol }) => symbol === '*')) return null;
  const whole = imported.find(({ symbol }) => symbol === null);
  if (whole?.nameNode) {
    const code = `${textOf(program, whole.nameNode)}.${name}`;
    return withMend({ key: 'error.forgottenOwner', values: { name, code }, ...lineWith(name, code, source) }, source.text, source.line); // prettier-ignore
  }
  const values = { name, code: found.code };
  const after = withImport(program, found.code);
  return { key: 'error.forgottenImport', values, mend: { before: source.text, after, code: found.code, adds: true } };
}

/** The failing line with one name written otherwise; nothing where the name stands there more than once. */
function lineWith(name: string, right: string, { text, line }: Source): { line?: string } {
  const written = text.split('\n')[line - 1] ?? '';
  const word = new RegExp(`(^|[^\\w.])${name}\\b`, 'g');
  return (written.match(word) ?? []).length === 1 ? { line: written.replace(word, `$1${right}`) } : {};
}

function renamed(failure: Failure, meant: string, { text, line }: Source): SyntaxAdvice['mend'] {
  const name = missingName(failure) ?? '';
  const written = text.split('\n')[line - 1] ?? '';
  const [column, another] = placesOf(name, written);
  if (column === undefined || another !== undefined || text.includes('\r')) return undefined;
  const right = written.slice(0, column) + meant + written.slice(column + name.length);
  const { mend } = withMend({ key: 'error.NameError', values: {}, line: right }, text, line);
  return mend && { ...mend, code: meant };
}

/** py/argcheck.c and py/bc.c, about the values of a call. */
const CALL_REFUSED =
  /takes \d+ positional|missing \d+ required|missing required positional|argument required|expected at most \d+ arguments|extra (?:positional|keyword)|argument num/;

/** Advice on a call with too many or too few values: the parameters of its function. `null`: none. */
function callAdvice({ type, message }: Failure, source: Source, written: Written): SyntaxAdvice | null {
  if (type !== 'TypeError' || !CALL_REFUSED.test(message)) return null; // prettier-ignore
  const named = /^(\w+)\(\)/.exec(message)?.[1] ?? null;
  const program = readPython(source.text);
  const reader = new Reader(program, contextOf(written));
  const calls = callsInLine(program, source.line)
    .filter((call) => named === null || lastWord(program, call.firstChild) === named)
    .map((call) => knownCall(program, reader, call));
  // The device does not say which function it was: of several in a line, the one whose brackets do not fit it.
  const [call = null, another] = calls.length > 1 ? calls.filter((it) => it !== null && !it.fits) : calls;
  if (call === null || another !== undefined) return null;
  const { callee, name, given, parameters } = call;
  // A method without self gets one value more than is written.
  if (given === 0 && / takes 0 positional/.test(message))
    return { key: 'error.selfMissing', values: { name: lastWord(program, callee) } };
  const comma = decimalComma(program, call.node, call.takes);
  if (comma !== null) return commaAdvice(comma, source);
  const [first, more] = parameters;
  if (first !== undefined && more === undefined && call.item.limits[first.name]?.unit === 'm')
    return { key: 'error.wantsMetres', values: { code: `${name}(0.2)` } };
  const wanted = parameters.map(({ name: it, text, rest }) => {
    const usual = text.includes('=') ? `=${text.slice(text.indexOf('=') + 1).trim()}` : '';
    return rest ? text.split(':')[0] : `${it}${usual}`;
  });
  return wanted.length === 0
    ? { key: 'error.wantsNothing', values: { name } }
    : { key: 'error.wantsThis', values: { code: `${name}(${wanted.join(', ')})` } };
}

/** The program with points for the commas in the line of the call. */
function commaAdvice({ code, change: { from, to, insert } }: DecimalComma, { text, line }: Source): SyntaxAdvice {
  const right = (text.slice(0, from) + insert + text.slice(to)).split('\n')[line - 1] ?? '';
  return withMend({ key: 'error.decimalComma', values: { code }, line: right }, text, line);
}

const lastWord = (program: PythonText, callee: SyntaxNode | null): string =>
  callee === null ? '' : (/\w+$/.exec(textOf(program, callee))?.[0] ?? '');

function callsInLine(program: PythonText, line: number): readonly SyntaxNode[] {
  const lines = program.text.split('\n');
  const from = lines.slice(0, line - 1).reduce((sum, { length }) => sum + length + 1, 0);
  const to = from + (lines[line - 1] ?? '').length;
  const calls: SyntaxNode[] = [];
  program.tree.iterate({
    from,
    to,
    enter: ({ name, node }) => {
      if (name === 'CallExpression' && node.from >= from && node.from < to) calls.push(node);
    },
  });
  return calls;
}
