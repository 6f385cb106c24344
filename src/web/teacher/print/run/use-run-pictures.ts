import { computed, onScopeDispose, shallowRef, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { liveScene } from '../../../pupil/arena/picture/live-scene';
import { shownLanguage } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import { useRun } from '../../../session/run/parts';
import type { RunTape } from '../../../session/run/unpack-tape';
import { clockText } from '../../../session/run/use-run-text';
import { wholeRecording } from '../../../session/run/fill/whole-recording';
import { colorsOfDevices } from '../../../session/work/hardware/device-colors';
import { hardwareNow } from '../../../session/work/hardware/use-hardware';
import { useWork } from '../../../session/work/model/parts';
import { runPainter, type RunPainter } from './run-painter';
import { runTape } from './run-tape';
import { firstStretch, withEnd, type Stretch } from './stretch';
import type { Caption } from './strip';

/** A run that pictures are made of. */
export interface RunPictures {
  /** `null` until its moments are there. */
  readonly tape: Readonly<ShallowRef<RunTape | null>>;
  readonly endUs: () => number;
  readonly stretch: Readonly<ShallowRef<Stretch>>;
  /** Moves an end of the stretch. */
  move(end: keyof Stretch, timeUs: number): void;
  /** The way of the robots is drawn. */
  readonly hasTrace: ShallowRef<boolean>;
  /** Makes a painter of its moments, with this longer side in px. Rejects while there is no tape. */
  painter(longestPx: number): Promise<RunPainter>;
  /** The caption of a moment. */
  caption(moment: Snapshot, timeUs: number): Caption;
}

/** The run that is looked back at, for as long as the component lives. */
export function useRunPictures(): RunPictures {
  const app = { ...useRun(), ...useWork() };
  const { run, work, settings } = app;
  const { value: recording } = run.recording;
  const tape = shallowRef<RunTape | null>(null);
  const atUs = run.nowUs.value;
  const stretch = shallowRef<Stretch>({ fromUs: 0, toUs: atUs });
  let isWanted = true;
  onScopeDispose(() => (isWanted = false));
  void (async () => {
    await wholeRecording(run, 'all moments');
    const whole = await runTape(recording, () => isWanted);
    if (whole === null) return;
    stretch.value = firstStretch(whole.rows.endUs, run.present.value?.verdict ?? null);
    tape.value = whole;
  })();
  const endUs = (): number => tape.value?.rows.endUs ?? atUs;
  const several = computed(() => work.devices.value.length > 1);
  const hasTrace = shallowRef(settings.current.value.trace);
  return {
    ...{ tape, endUs, stretch, hasTrace },
    move: (end, timeUs) => (stretch.value = withEnd(stretch.value, end, Math.round(timeUs), endUs())),
    painter(longestPx) {
      const whole = tape.value;
      const first = whole?.rows.at(stretch.value.fromUs) ?? null;
      if (whole === null || first === null) return Promise.reject(new Error('There is no run.'));
      const { scene } = liveScene(work.scene.value, recording.setup?.scene ?? null);
      const robots = work.devices.value.map((_, place) => hardwareNow(app, place));
      const trails = hasTrace.value ? whole.trails : null;
      return runPainter({ scene, robots, colors: colorsOfDevices(app), trails }, longestPx, first);
    },
    caption(moment, timeUs) {
      const place = work.place.value;
      const device = place === 0 ? moment : moment.others[place - 1];
      const position = device?.position ?? null;
      const files = recording.setup?.devices[place]?.files ?? {};
      const text = position && files[position.file]?.split('\n')[position.line - 1]?.trim();
      const name = several.value ? `  ${String(work.devices.value[place])}` : '';
      const time = `${clockText(timeUs, true)}${name}`;
      return { time, line: position && { number: position.line, text: text ?? position.file } };
    },
  };
}

/** A time of the run in seconds, to be read: `12.4`. */
export const secondsText = (us: number): string => numberText(us / 1_000_000, shownLanguage(), 1);
