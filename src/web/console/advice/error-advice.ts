import type { OnTable } from '../../work/hardware/misplugged';
import type { TextKey, TextValues } from '../../page/i18n/texts';
import { errorTable } from './error-table';
import { lineAdvice } from './line-advice';
import { nameAdvice } from './name-slips';
import { syntaxAdvice, type Mend, type Source } from './syntax-advice';

/** An explanation of an error in the pupil's language: a text's name and what goes into it. */
export interface Advice {
  readonly key: TextKey;
  readonly values: TextValues;
  /** The device's own words, such as `NameError: name 'x' isn't defined`. */
  readonly device: string;
  /** What a button would write, where it is sure. */
  readonly mend?: Mend;
}

/** What an exception looks like to the page. */
export interface Failure {
  readonly type: string;
  readonly message: string;
  readonly traceback?: string;
}

/** All that an explanation is made of. */
export interface ErrorReport {
  readonly failure: Failure;
  /** The pupil's file and the line that the exception names. */
  readonly source: Source | null;
  readonly table: OnTable | null;
}

/** Exceptions that have one text whatever the device says. */
const PLAIN = [
  'SyntaxError', 'IndentationError', 'TypeError', 'ValueError', 'ZeroDivisionError', 'IndexError', 'MemoryError', 'OSError',
  'AssertionError', 'NotImplementedError', 'RuntimeError', 'StopIteration', 'UnicodeError', 'OverflowError',
  'KeyboardInterrupt',
] as const; // prettier-ignore

/** Values are the pupil's own text at times; this much of it fits into a sentence. */
const SHOWN_CHARACTERS = 40;

/**
 * What a pupil should read about an exception: first in their words, then in the device's.
 *
 * @param source the pupil's file and the line the exception names. With it, "invalid syntax" can be explained.
 * @param table what is plugged in. With it, a robot that does not answer can be explained.
 */
export function adviceFor(
  { type, message, traceback = '' }: Failure,
  source: Source | null = null,
  table: OnTable | null = null,
): Advice {
  const device = message === '' ? type : `${type}: ${message}`;
  if (type === 'MemoryError' && traceback.includes('too long for the board'))
    return { key: 'error.tooLong', values: {}, device };
  const general = type === 'SyntaxError' && message === 'invalid syntax';
  const found =
    source &&
    (general ? syntaxAdvice(source) : (nameAdvice(type, message, source) ?? lineAdvice(type, message, source)));
  if (found !== null) return { ...found, values: shortened(found.values), device };
  const advice = explained(type === 'ModuleNotFoundError' ? 'ImportError' : type, message);
  return { ...(table === null ? advice : atTable(advice, table)), device };
}

/** Why no robot or chip answers, seen from what is plugged in. */
function atTable(advice: Omit<Advice, 'device'>, { robot, fault }: OnTable): Omit<Advice, 'device'> {
  const isRobot = advice.key === 'error.noRobot';
  if (!isRobot && advice.key !== 'error.noDevice') return advice;
  if (fault !== null) return fault;
  if (robot === null) return isRobot ? advice : { key: 'error.noDeviceBare', values: {} };
  return isRobot ? { key: 'error.robotSilent', values: { robot } } : advice;
}

function explained(type: string, message: string): Omit<Advice, 'device'> {
  for (const pattern of errorTable) {
    if (pattern.type !== type) continue;
    const match = pattern.words.exec(message);
    if (match === null) continue;
    const values = (pattern.values ?? []).map((name, index) => [name, short(readable(match[index + 1] ?? ''))]);
    return { key: pattern.key, values: Object.fromEntries(values) as TextValues };
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

const shortened = (values: TextValues): TextValues =>
  Object.fromEntries(
    Object.entries(values).map(([name, value]) => [name, typeof value === 'string' ? short(value) : value]),
  );

const short = (text: string): string => (text.length > SHOWN_CHARACTERS ? `${text.slice(0, SHOWN_CHARACTERS)}…` : text);
