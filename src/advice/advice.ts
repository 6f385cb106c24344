import type { AdviceKey, AdviceValues } from './text';
import { errorTable } from './error-table';
import { lineAdvice } from './line-advice';
import { atTable, type AtTable } from './at-table';
import { nameAdvice } from './name-slips';
import { robotAdvice } from './robot-advice';
import { syntaxAdvice, type Mend, type Source } from './syntax-advice';

/** An explanation of an error in the pupil's language: a text's name and what goes into it. */
export interface Advice {
  readonly key: AdviceKey;
  readonly values: AdviceValues;
  /** The device's own words, such as `NameError: name 'x' isn't defined`. */
  readonly device: string;
  /** The correction that a button would make, if the error leaves only one. */
  readonly mend?: Mend;
}

/** An exception as MicroPython reports it. */
export interface Failure {
  readonly type: string;
  readonly message: string;
  readonly traceback?: string;
}

/** Exceptions with one text regardless of the device's message. */
const PLAIN = [
  'SyntaxError', 'IndentationError', 'TypeError', 'ValueError', 'ZeroDivisionError', 'IndexError', 'MemoryError', 'OSError',
  'AssertionError', 'NotImplementedError', 'RuntimeError', 'StopIteration', 'UnicodeError', 'OverflowError',
  'KeyboardInterrupt',
] as const; // prettier-ignore

/** Values are the pupil's own text at times; this much of it fits into a sentence. */
const SHOWN_CHARACTERS = 40;

/**
 * The explanation of an exception for pupils: first in their words, then in the device's.
 *
 * @param source the pupil's file and the line the exception names; "invalid syntax", for example, needs it
 * @param table what is plugged in. With it, a robot that does not answer can be explained
 */
export function adviceFor(failure: Failure, source: Source | null = null, table: AtTable | null = null): Advice {
  const advice = byDevice(failure, source);
  return table === null ? advice : atTable(advice, table);
}

/** The explanation without knowing what is plugged in. */
function byDevice(failure: Failure, source: Source | null): Advice {
  const { type, message, traceback = '' } = failure;
  const device = message === '' ? type : `${type}: ${message}`;
  if (type === 'MemoryError' && traceback.includes('too long for the board'))
    return { key: 'error.tooLong', values: {}, device };
  const ofRobot = robotAdvice(type, message, source);
  if (ofRobot !== null) return { ...ofRobot, device };
  const general = type === 'SyntaxError' && message === 'invalid syntax';
  const found =
    source &&
    (general ? syntaxAdvice(source) : (nameAdvice(type, message, source) ?? lineAdvice(type, message, source)));
  if (found !== null) return { ...found, values: shortened(found.values), device };
  return { ...explained(type === 'ModuleNotFoundError' ? 'ImportError' : type, message), device };
}

function explained(type: string, message: string): Omit<Advice, 'device'> {
  for (const pattern of errorTable) {
    if (pattern.type !== type) continue;
    const match = pattern.words.exec(message);
    if (match === null) continue;
    const values = (pattern.values ?? []).map((name, index) => [name, short(readable(match[index + 1] ?? ''))]);
    return { key: pattern.key, values: Object.fromEntries(values) as AdviceValues };
  }
  const plain = PLAIN.find((name) => name === type);
  return { key: plain === undefined ? 'error.other' : `error.${plain}`, values: {} };
}

/** Turns letters that the device wrote as the bytes of UTF-8, `\xc3\xb6`, into letters again; other bytes stay. */
function readable(text: string): string {
  return text.replace(/(?:\\x[0-9a-f]{2})+/g, (codes) => {
    const bytes = Array.from(codes.matchAll(/[0-9a-f]{2}/g), ([byte]) => Number.parseInt(byte, 16));
    try {
      return new TextDecoder('utf-8', { fatal: true }).decode(Uint8Array.from(bytes));
    } catch {
      return codes;
    }
  });
}

const shortened = (values: AdviceValues): AdviceValues =>
  Object.fromEntries(
    Object.entries(values).map(([name, value]) => [name, typeof value === 'string' ? short(value) : value]),
  );

const short = (text: string): string => (text.length > SHOWN_CHARACTERS ? `${text.slice(0, SHOWN_CHARACTERS)}…` : text);
