import type { Source, SyntaxAdvice } from './syntax-advice';

/** Strings in quotation marks and comments of a line. */
const TEXTS = /(["'])((?:\\.|(?!\1).)*)\1|#.*/g;
const NUMBERS: readonly string[] = ['int', 'float', 'bool'];
const FUNCTIONS: readonly string[] = ['function', 'bound_method', 'closure'];
/** Words that may be followed by brackets but are not functions. */
const WORDS = /^(?:if|elif|while|for|in|and|or|not|return|print|lambda|yield|assert|del|is|else)$/;

/** Explains an error whose message leaves out what the line that failed shows; `null` in doubt. */
export function lineAdvice(type: string, message: string, { text, line }: Source): SyntaxAdvice | null {
  const written = text.split('\n')[line - 1] ?? '';
  const code = written.replace(TEXTS, '""');
  if (type === 'ValueError' && /^invalid syntax for integer with base \d+$/.test(message)) return notWhole(written);
  if (type !== 'TypeError') return null;
  const stranger = /^can't convert '(\w+)' object to str implicitly/.exec(message)?.[1];
  if (stranger !== undefined) return besideText(stranger, code);
  const counts = /^function takes (\d+) positional arguments but (\d+) were/.exec(message);
  const [, expected = '', given = ''] = counts ?? [];
  const name = counts === null ? null : onlyCall(code);
  return name === null ? null : { key: 'error.argumentCount', values: { name, expected, given } };
}

/** The text given to `int` in the line. */
function notWhole(written: string): SyntaxAdvice | null {
  const found = /\bint\(\s*(["'])((?:\\.|(?!\1).)*)\1\s*[,)]/.exec(written)?.[2];
  if (found === undefined) return null;
  return found === ''
    ? { key: 'error.wholeOfNothing', values: {} }
    : { key: 'error.wholeOfText', values: { text: found } };
}

/** A text and something else on either side of an operator. */
function besideText(type: string, code: string): SyntaxAdvice | null {
  const operator = /\+/.exec(code) ?? /[<>]/.exec(code) ?? /[-*/%]/.exec(code);
  if (operator === null) return null;
  if (type === 'NoneType') return { key: 'error.operandNone', values: {} };
  if (FUNCTIONS.includes(type)) return { key: 'error.callForgotten', values: {} };
  const compares = /[<>]/.test(operator[0]);
  const values = { left: 'str', right: type };
  if (!NUMBERS.includes(type)) return { key: compares ? 'error.compareTypes' : 'error.operandTypes', values };
  if (compares) return { key: 'error.compareTextNumber', values: {} };
  return { key: operator[0] === '+' ? 'error.addTextNumber' : 'error.textReckon', values: {} };
}

/** The name of the function that is called, where a line calls one alone. */
function onlyCall(code: string): string | null {
  const names = Array.from(code.matchAll(/([\p{L}_][\p{L}\d_]*)\s*\(/gu), ([, name = '']) => name);
  const called = names.filter((name) => !WORDS.test(name));
  const [name] = called;
  return called.length === 1 && !/^\s*(?:def|class)\b/.test(code) ? (name ?? null) : null;
}
