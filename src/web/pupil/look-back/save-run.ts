import { PHYSICS } from '#simulation/physics-version';
import { setupAsKept, tapeToText } from '#tape/file';
import { RUN_LINK_CHARACTERS, runLinkOf } from '#tape/link';
import type { Tape } from '#tape/tape';
import { version } from '../../../../package.json';
import type { PageParts } from '../../kit/parts';
import { t } from '../../kit/i18n';
import type { RunParts } from '../../session/run/parts';
import { repeatShown } from '../../session/run/repeat-shown';
import type { RunModel } from '../../session/run/run-model';
import { wholeRecording } from '../../session/run/fill/whole-recording';
import type { WorkParts } from '../../session/work/model/parts';
import { fileName, saveText } from '../../session/work/save-file';
import { nameToSave } from '../../session/work/work-name';
import words from './words';

type Recorded = Pick<Tape, 'setup' | 'untilUs' | 'untilProgramEnds'>;

/** A call of a program that is not over at the end of a run is finished first: so far the clock may be later, µs. */
const CALL_US = 10_000;

type App = Pick<PageParts, 'notices'> & Pick<RunParts, 'run'> & WorkParts;

/** Saves the run so far as a file, the same as `parcours run --record` writes. */
export async function saveRun(app: App): Promise<void> {
  const text = await textOfRun(app);
  if (text !== null) saveText(app, fileName(nameToSave(app), 'run.json'), text, 'application/json');
}

/** Links to a run. */
export interface RunLinks {
  readonly fromStart: string;
  /** From the moment that is looked at. */
  readonly fromThere: string;
}

/** The links to the run so far; `null`: there are none, and a message says why. */
export async function linksToRun(app: App): Promise<RunLinks | null> {
  const atUs = app.run.nowUs.value;
  const text = await textOfRun(app);
  if (text === null) return null;
  const link = runLinkOf(text, atUs);
  const linked = (from: string): string => `${location.origin}${location.pathname}#${from}`;
  if (link.length <= RUN_LINK_CHARACTERS) return { fromStart: linked(runLinkOf(text, 0)), fromThere: linked(link) };
  const said = t(words.linkTooLong, { count: link.length, max: RUN_LINK_CHARACTERS });
  app.notices.show({ kind: 'warn', key: 'notice.text', values: { text: said } });
  return null;
}

/**
 * The file of the run so far. The run is repeated for it: the result in the file is that of the repetition.
 *
 * @returns `null`: it was given up, or a message says why
 */
async function textOfRun(app: App): Promise<string | null> {
  const recorded = await recordedNow(app.run);
  if (recorded === null) return null;
  const { untilUs, untilProgramEnds } = recorded;
  try {
    const setup = setupAsKept(recorded.setup);
    const wish = { setup, untilUs, untilProgramEnds };
    const repeated = await repeatShown(app, wish, (percent) => t(words.saving, { percent }));
    return (
      repeated &&
      tapeToText({ madeBy: version, physics: PHYSICS, setup, untilUs, untilProgramEnds, result: repeated.result })
    );
  } catch {
    app.notices.show({ kind: 'error', key: 'notice.text', values: { text: t(words.saveFailed) } });
    return null;
  }
}

/** The run up to now, with all that was done to it; `null`: it is gone. */
async function recordedNow(run: RunModel): Promise<Recorded | null> {
  const recording = await wholeRecording(run, 'the inputs');
  const [setup, inputs] = [recording?.setup ?? null, recording?.inputs.value ?? null];
  const endUs = run.present.value?.timeUs ?? 0;
  if (setup === null || inputs === null) return null;
  const as = recording?.broughtTape ?? null;
  // Nothing was done to it since it was opened, and it stands where it ended: it is saved as it came.
  if (as !== null && inputs.length === (setup.inputs ?? []).length && endUs <= as.untilUs + CALL_US)
    return { setup, ...as.ends };
  const done = inputs.filter(({ timeUs }) => timeUs <= endUs);
  return { ...untilStop({ setup: { ...setup, inputs: done }, untilUs: endUs }), untilProgramEnds: false };
}

/** A stopped run up to the stop: Stop interrupts the programs, and what they print then does not count as the run's. */
function untilStop({ setup, untilUs }: Omit<Recorded, 'untilProgramEnds'>): Omit<Recorded, 'untilProgramEnds'> {
  const { inputs = [] } = setup;
  const last = inputs.at(-1);
  if (last?.action.type !== 'interrupt') return { setup, untilUs };
  const isStop = (event: typeof last): boolean => event.action.type === 'interrupt' && event.timeUs === last.timeUs;
  return { setup: { ...setup, inputs: inputs.filter((event) => !isStop(event)) }, untilUs: last.timeUs };
}
