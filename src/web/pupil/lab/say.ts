import { reasonText } from '#lab/say';
import type { Value } from '#lab/what';

import { shownLanguage, t } from '../../kit/i18n';
import { numberText } from '../../kit/i18n/number-text';
import type { Fault } from './model/faults';
import type { LabRun, Series } from './model/lab-model';
import { numberThings, type Thing } from './model/things';
import words from './words';

/** A simulated time in words. */
export const timeText = (ms: number): string =>
  t(words.seconds, { seconds: numberText(ms / 1000, shownLanguage(), 1) });

/** A wall time in words, never too short. */
export function wallText(ms: number): string {
  const seconds = Math.max(1, Math.ceil(ms / 1000));
  return seconds < 90 ? t(words.seconds, { seconds }) : t(words.minutes, { minutes: Math.ceil(seconds / 60) });
}

/** A value as people write it. */
export const valueText = (value: Value | undefined): string =>
  typeof value === 'number' ? numberText(value, shownLanguage()) : (value ?? '');

/** The values of a run, in words. */
export const valuesText = ({ values }: LabRun): string => values.map(valueText).join(' · ');

/** The result of a run in a few words. */
export function outcomeText({ passed, atMs, reason, pathMm }: LabRun): string {
  if (passed === true) return atMs === null ? t(words.passed) : t(words.passedIn, { time: timeText(atMs) });
  if (reason !== null) return reasonText(reason, shownLanguage());
  if (passed === false) return t(words.missed);
  return pathMm === null ? t(words.ended) : t(words.drove, { way: Math.round(pathMm / 10) });
}

/** The differences of the used robot of a run, in a few words. */
export const faultsText = (faults: readonly Fault[]): string => faults.map(faultText).join(', ');

function faultText(fault: Fault): string {
  const { pulls, sees } = words.faults;
  switch (fault.kind) {
    case 'pulls':
      return t(pulls[fault.isHard ? 'hard' : 'little'][fault.to]);
    case 'weaker':
      return t(words.faults.weaker, fault);
    case 'sees':
      return t(sees[fault.isLighter ? 'lighter' : 'darker'][fault.side]);
    case 'trembles':
      return t(words.faults.trembles);
  }
}

/** The name of a thing in a list. */
export function thingText({ name, number }: Thing): string {
  if (number !== null) {
    const file = number.file === 'main.py' ? '' : `${number.file} · `;
    return file + t(words.line, { line: number.line, shown: number.shown });
  }
  if (name === 'start.x') return t(words.things.x);
  if (name === 'start.y') return t(words.things.y);
  if (name === 'seed') return t(words.things.seed);
  return name === 'start.heading' ? t(words.things.heading) : t(words.things.reality);
}

/** The name of what varies in a series, for an axis. */
export function axisText({ base }: Series, name: string): string {
  const line = numberThings(base.setup).find((one) => one.name === name)?.number?.line;
  return line === undefined ? thingText({ name, now: 0, number: null }) : t(words.lineOnly, { line });
}
