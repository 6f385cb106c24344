import { shallowRef } from 'vue';

import type { Scene } from '#scene/scene';

import { RadioModel } from '../run/radio-model';
import { RunModel, type RunHost } from '../run/run-model';
import { SensorsModel } from '../run/sensors-model';
import type { RunParts } from '../run/parts';
import { createWorker } from '../run/worker/create-worker';
import { compileFirmware } from '../run/worker/firmware';
import { troubleKey } from '../run/worker/firmware-trouble';
import type { VisitParts } from '../visit/parts';
import { runSetup } from '../work/run-setup';
import { showFailure, showStart, type RunMessages } from './run-messages';

/** The engine that runs a program: a worker and the VM. */
export type RunEngine = Pick<RunHost, 'createWorker' | 'firmware'>;

/** The worker and the VM of the built page. */
export const browserEngine: RunEngine = { createWorker, firmware: compileFirmware };

/** The models that a run uses. */
type Around = RunMessages & VisitParts & Pick<RunParts, 'hand' | 'dataLog' | 'sound' | 'listeners'>;

/** Makes the run and what reaches into it; whatever comes out of it goes to listeners, notices, sound and host. */
export function createRun(models: Omit<Around, 'listeners'>, engine: RunEngine): RunParts {
  const around: Around = { ...models, listeners: [] };
  const { hand, dataLog, sound, listeners } = around;
  const runStart = shallowRef<Scene | null>(null);
  const run: RunModel = new RunModel({
    ...engine,
    setup: (kept) => {
      const setup = kept ?? runSetup(around, (place) => sensors.startInputs(place));
      runStart.value = setup.scene;
      return setup;
    },
    refuses: (action) => around.work.locks.refusesInput(action),
    device: () => around.work.place.value,
    ...outcome(around, () => run),
    onEvents: (events, device) => {
      radio.take(events.radio, events.radioDropped, device);
      dataLog.take(events.log, device);
      if (device === run.device) sound.take(events.sound);
      const from = further(around, device);
      if (events.radio.length > 0)
        around.host.tell({ type: 'radio', packets: events.radio, dropped: events.radioDropped, ...from });
      if (events.log.length > 0) around.host.tell({ type: 'log', events: events.log, ...from });
    },
    ...starting(around, () => radio.clear()),
    ...troubles(around, () => run),
  });
  const sensors = new SensorsModel(run);
  const radio = new RadioModel(run);
  return { run, runStart, listeners, sensors, radio, dataLog, sound, hand };
}

/** The name of a further device, for a host. */
function further({ work }: Around, device: number): { readonly device?: string } {
  const name = device === 0 ? undefined : work.devices.value[device];
  return name === undefined ? {} : { device: name };
}

/** Actions at the start of a run. */
function starting(around: Around, clearRadio: () => void): Pick<RunHost, 'onStart' | 'onRestarted'> {
  const { host, dataLog, notices, hand, listeners } = around;
  return {
    onStart: () => {
      hand.reset();
      host.tell({ type: 'started' });
      showStart(around);
      for (const it of listeners) it.onStart?.();
      dataLog.clear();
      clearRadio();
    },
    onRestarted: (device) => {
      host.tell({ type: 'program-restarted', ...further(around, device) });
      for (const it of listeners) it.onRestarted?.(device);
      notices.close();
    },
  };
}

/** The inputs to a run, its output and its result. */
function outcome(around: Around, run: () => RunModel): Pick<RunHost, 'onInput' | 'onOutput' | 'onEnded'> {
  const { host, listeners } = around;
  return {
    onInput: (action, device) => {
      const { type } = action;
      if (type === 'button' || type === 'touch' || type === 'sensor')
        host.tell({ type: 'sensed', action, ...further(around, device) });
    },
    onOutput: (output) => {
      run().recording.value.addOutput(output);
      for (const it of listeners) it.onOutput?.(output);
      host.tell({ type: 'output', text: output.text, ...further(around, output.device) });
    },
    onEnded: (ended, device) => {
      for (const it of listeners) it.onEnded?.(ended, device);
      const verdict = run().snapshot.value?.verdict ?? null;
      host.tell({ type: 'program-ended', ended, verdict, ...further(around, device) });
    },
  };
}

/** Messages on a run that goes wrong through no fault of the program. */
function troubles(
  around: Around,
  run: () => RunModel,
): Pick<RunHost, 'onFailed' | 'onRefused' | 'onSlow' | 'onUnavailable' | 'onKilled'> {
  const { notices, host } = around;
  return {
    onFailed: (message) => {
      void showFailure(around, message);
      host.tell({ type: 'failed', message });
    },
    onRefused: (message) => {
      notices.show({ kind: 'info', key: 'notice.refused', values: { message } });
      host.tell({ type: 'refused', message });
    },
    onSlow: () =>
      notices.show({ kind: 'info', key: 'notice.firmwareSlow', holds: () => run().phase.value === 'starting' }),
    onUnavailable: (why) => {
      notices.show({ kind: 'error', key: troubleKey(why) });
      host.tell({ type: 'failed', message: 'A part of the simulator could not be fetched.' });
    },
    onKilled: () => notices.show({ kind: 'warn', key: 'notice.killed' }),
  };
}
