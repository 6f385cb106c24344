import { courseEditorOf } from '../../course/editor/state/parts';
import { consoleOf } from '../../pupil/console/parts';
import { debugOf } from '../../pupil/debug/parts';
import type { SetUp } from '../../session/models/session';
import { listenToHost } from './listen-to-host';

export const setUp: SetUp = (session) =>
  listenToHost({ ...session, ...consoleOf(session), ...courseEditorOf(session), ...debugOf(session) });
