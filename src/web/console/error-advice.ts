import type { TextKey, TextValues } from '../i18n/texts';

/** An explanation of an error in the pupil's language: a text's name and what goes into it. */
export interface Advice {
  readonly key: TextKey;
  readonly values: TextValues;
  /** The device's own words, such as `NameError: name 'x' isn't defined`. */
  readonly device: string;
}

/** What an exception looks like to the page. */
export interface Failure {
  readonly type: string;
  readonly message: string;
  readonly traceback?: string;
}

const PLAIN = [
  'SyntaxError', 'IndentationError', 'TypeError', 'ValueError', 'ZeroDivisionError', 'IndexError', 'KeyError', 'MemoryError',
  'AssertionError', 'NotImplementedError',
] as const; // prettier-ignore

/** What a pupil should read about an exception: first in their words, then in the device's. */
export function adviceFor({ type, message, traceback = '' }: Failure): Advice {
  const device = message === '' ? type : `${type}: ${message}`;
  if (type === 'MemoryError' && traceback.includes('too long for the board'))
    return { key: 'error.tooLong', values: {}, device };
  const plain = PLAIN.find((name) => name === type);
  if (plain !== undefined) return { key: `error.${plain}`, values: {}, device };
  return { ...special(type, message), device };
}

/** Explanations that depend on the exception's own words. */
function special(type: string, message: string): Omit<Advice, 'device'> {
  const quoted = /'([^']+)'/g;
  const names = [...message.matchAll(quoted)].map((match) => match[1] ?? '');
  switch (type) {
    case 'NameError':
      return named('error.NameError', 'error.NameErrorAny', names[0]);
    case 'AttributeError':
      return named('error.AttributeError', 'error.AttributeErrorAny', names[1]);
    case 'ImportError':
    case 'ModuleNotFoundError':
      return named('error.ImportError', 'error.ImportErrorAny', names[0]);
    case 'RuntimeError':
      return { key: message.includes('recursion') ? 'error.recursion' : 'error.RuntimeError', values: {} };
    case 'OSError':
      return { key: osError(message), values: {} };
    default:
      return { key: 'error.other', values: {} };
  }
}

function named(withName: TextKey, without: TextKey, name: string | undefined): Omit<Advice, 'device'> {
  return name === undefined ? { key: without, values: {} } : { key: withName, values: { name } };
}

/** MicroPython says `[Errno 19] ENODEV`, or just the number. */
function osError(message: string): TextKey {
  const errno = /\d+/.exec(message)?.[0];
  if (errno === '19') return 'error.noDevice';
  return errno === '2' ? 'error.noFile' : 'error.OSError';
}
