import type { SourceFile } from '#project/project';
import type { Ended } from '#simulation/simulation';

import { t } from '../../kit/i18n';
import { robotInErrorNow } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import { explain } from './advice/explain';
import { lastPlace, type ErrorPlace } from './log/console-log';

/** The sentence on an error; `''` for a program that ended without one. */
export function errorSentence(ended: Ended, parts: WorkParts): string {
  const text = errorText(ended, parts);
  return text === null ? '' : t(text.key, text.values);
}

/** An exception in a sentence, with its line where it has one; `null` without an exception. */
export function errorText({ exception }: Ended, parts: WorkParts) {
  if (exception === null) return null;
  const files = parts.work.files.value;
  const place = placeIn(exception.traceback, files);
  const advice = explain({ failure: exception, source: sourceAt(place, files), table: robotInErrorNow(parts) });
  const message = t(advice.key, advice.values);
  return place === null
    ? { key: 'state.announceError' as const, values: { message } }
    : { key: 'state.announceErrorLine' as const, values: { ...place, message } };
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
