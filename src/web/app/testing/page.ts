import { effectScope, type EffectScope } from 'vue';

import { fakeWorker } from '../../session/run/testing/fake-worker';
import type { FromWorker, ToWorker } from '../../session/run/worker/protocol';
import { noHost, type HostWish } from '../../session/visit/host-view';
import { nothingKept, type Opened } from '../../session/work/model/keep-work';
import { courseEditorOf, type CourseEditorParts } from '../../course/editor/state/parts';
import { firstStepsOf, type FirstStepsParts } from '../../help/parts';
import { consoleOf, type ConsoleParts } from '../../pupil/console/parts';
import { debugOf, type DebugParts } from '../../pupil/debug/parts';
import type { RunEngine } from '../../session/models/create-run';
import type { SessionParts } from '../../session/models/session';
import { createModels } from '../create-models';

/** The models of the session and of the rooms above it. */
export type AllParts = SessionParts & ConsoleParts & DebugParts & CourseEditorParts & FirstStepsParts;

/** Makes all models as the page does. It needs a document: happy-dom in Node. */
export function createParts(opened: Opened, wish: HostWish, engine?: RunEngine): AllParts {
  const session = createModels(opened, wish, engine);
  return {
    ...session,
    ...consoleOf(session),
    ...debugOf(session),
    ...courseEditorOf(session),
    ...firstStepsOf(session),
  };
}

/** A page without its components: all models, joined as in the browser. Its worker runs no program; the test speaks for it. */
export interface TestPage extends AllParts {
  /** The messages sent to the worker so far. */
  readonly sent: readonly ToWorker[];
  /** Says something for the worker. */
  readonly say: (message: FromWorker) => void;
  /** Ends what the models listen to. */
  readonly scope: EffectScope;
}

/** Makes the models of a page that keeps nothing. It needs a document: happy-dom in Node. */
export function createPage(wish: Partial<HostWish> = {}): TestPage {
  const { sent, say, engine } = fakeWorker();
  const scope = effectScope(true);
  const parts = scope.run(() => createParts(nothingKept, { ...noHost, ...wish }, engine));
  if (parts === undefined) throw new Error('The scope of the page has ended.');
  return { ...parts, sent, say, scope };
}
