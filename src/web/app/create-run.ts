import { watch, type ShallowRef } from 'vue';

import type { Scene } from '#scene/scene';

import { fetchAdvice } from '../pupil/console/advice/explain';
import { RadioModel } from '../session/run/radio-model';
import { RunModel, type RunHost } from '../session/run/run-model';
import { SensorsModel } from '../session/run/sensors-model';
import type { RunParts } from '../session/run/parts';
import { createWorker } from '../session/run/worker/create-worker';
import { compileFirmware } from '../session/run/worker/firmware';
import { troubleKey } from '../session/run/worker/firmware-trouble';
import type { VisitParts } from '../session/visit/parts';
import { runSetup } from '../session/work/run-setup';
import { showEnd, showFailure, showStart, type RunMessages } from './run-messages';

/** Time from the start of the first run until the page fetches what explains errors, in ms. */
const ADVICE_AFTER_MS = 2000; // chosen: the robot drives by then; an error before that fetches it at once

/** The engine that runs a program: a worker and the VM. */
export type RunEngine = Pick<RunHost, 'createWorker' | 'firmware'>;

/** The worker and the VM of the built page. */
export const browserEngine: RunEngine = { createWorker, firmware: compileFirmware };

/** The models that a run uses. */
type Around = RunMessages &
  VisitParts &
  Pick<RunParts, 'hand' | 'dataLog' | 'sound'> & {
    /** The course that the run was given. */
    readonly runStart: ShallowRef<Scene | null>;
  };

/** Makes the run and what reaches into it; whatever comes out of it goes to console, notices, sound and host. */
export function createRun(around: Around, engine: RunEngine): RunParts {
  const { hand, dataLog, sound } = around;
  const run: RunModel = new RunModel({
    ...engine,
    setup: (kept) => {
      const setup = kept ?? runSetup(around, (place) => sensors.startInputs(place));
      around.runStart.value = setup.scene;
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
  // At once: a reset leaves this phase in the same breath.
  watch(
    run.phase,
    (phase) => {
      if (phase === 'stopped') around.console.addNote('console.stopped');
    },
    { flush: 'sync' },
  );
  return { run, sensors, radio, dataLog, sound, hand };
}

/** The name of a further device, for a host. */
function further({ work }: Around, device: number): { readonly device?: string } {
  const name = device === 0 ? undefined : work.devices.value[device];
  return name === undefined ? {} : { device: name };
}

/** Actions at the start of a run. */
function starting(around: Around, clearRadio: () => void): Pick<RunHost, 'onStart' | 'onRestarted'> {
  const { host, jump, console, dataLog, notices, hand } = around;
  let runs = 0;
  return {
    onStart: () => {
      runs += 1;
      hand.reset();
      host.tell({ type: 'started' });
      jump.wrong.value = null;
      showStart(around);
      console.startRun(runs, around.work.devices.value.length);
      if (runs === 1) setTimeout(() => void fetchAdvice(), ADVICE_AFTER_MS);
      dataLog.clear();
      clearRadio();
    },
    onRestarted: (device) => {
      host.tell({ type: 'program-restarted', ...further(around, device) });
      jump.wrong.value = null;
      notices.close();
    },
  };
}

/** The inputs to a run, its output and its result. */
function outcome(around: Around, run: () => RunModel): Pick<RunHost, 'onInput' | 'onOutput' | 'onEnded'> {
  const { host, console } = around;
  return {
    onInput: (action, device) => {
      const { type } = action;
      if (type === 'button' || type === 'touch' || type === 'sensor')
        host.tell({ type: 'sensed', action, ...further(around, device) });
    },
    onOutput: (output) => {
      const { text, device, timeUs } = output;
      run().recording.value.addOutput(output);
      console.write(text, device, timeUs);
      host.tell({ type: 'output', text, ...further(around, device) });
    },
    onEnded: (ended, device) => {
      showEnd(around, ended, run(), device);
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
