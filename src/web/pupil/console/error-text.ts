import type { SourceFile } from '#project/project';
import type { Ended } from '#simulation/simulation';

import { t } from '../../kit/i18n';
import { robotInErrorNow } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import type { ErrorReport } from './advice/error-advice';
import { explain } from './advice/explain';
import type { LateAdvice } from './advice/late-advice';
import { lastPlace, type ErrorPlace } from './log/console-log';

/** Errors of a program that does not even begin. */
const UNREAD: readonly string[] = ['SyntaxError', 'IndentationError'];

/** True for an error of a program that could not be read: no line of it has run. */
export const isUnread = ({ failure }: ErrorReport): boolean => UNREAD.includes(failure.type);

/** The place of an error's cause: the device may notice an open bracket some lines below it. */
export function causeOf(report: ErrorReport, place: ErrorPlace | null): ErrorPlace | null {
  const { line } = explain(report).values;
  return place !== null && isUnread(report) && typeof line === 'number' ? { ...place, line } : place;
}

/** The explanation of how a program ended, as `explain` wants it; `null` without an exception. */
export function reportOf({ exception }: Ended, parts: WorkParts) {
  if (exception === null) return null;
  const files = parts.work.files.value;
  const place = placeIn(exception.traceback, files);
  return { place, report: { failure: exception, source: sourceAt(place, files), table: robotInErrorNow(parts) } };
}

/** The place of the cause of how a program ended; `null` without an error, or for one that names no line. */
export function causeOfEnd(ended: Ended | null, parts: WorkParts): ErrorPlace | null {
  const found = ended && reportOf(ended, parts);
  return found && causeOf(found.report, found.place);
}

/** The sentence on an error; `''` for a program that ended without one. */
export function errorSentence(ended: Ended, parts: WorkParts, late: LateAdvice | null = null): string {
  const text = errorText(ended, parts, late);
  return text === null ? '' : t(text.key, text.values);
}

/**
 * An exception in a sentence, with its line where it has one; `null` without an exception.
 *
 * @param late what the reference knows of it: a better sentence, or the name that was meant
 */
export function errorText(ended: Ended, parts: WorkParts, late: LateAdvice | null = null) {
  const found = reportOf(ended, parts);
  if (found === null) return null;
  const { key, values } = late?.advice ?? explain(found.report);
  const meant = late?.meant ?? null;
  const message = [t(key, values), ...(meant === null ? [] : [t('error.didYouMean', { name: meant })])].join(' ');
  const at = causeOf(found.report, found.place);
  return at === null
    ? { key: 'state.announceError' as const, values: { message } }
    : { key: 'state.announceErrorLine' as const, values: { ...at, message } };
}

/** The innermost line of a traceback that is in one of the files, or `null`. */
export const placeIn = (traceback: string, files: readonly SourceFile[]): ErrorPlace | null =>
  lastPlace(
    traceback,
    files.map(({ name }) => name),
  );

/** The text of the file and the line that an error names; `null` if the file is none of these. */
export function sourceAt(place: ErrorPlace | null, files: readonly SourceFile[]) {
  const file = files.find(({ name }) => name === place?.file);
  return place === null || file === undefined ? null : { text: file.text, line: place.line };
}
