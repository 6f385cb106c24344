import { courseEditorOf } from '../../course/editor/state/parts';
import type { JoinModels } from '../../session/models/session';
import { applyLocks } from './apply-locks';

/** The locks of a task hold while it is open. */
export const join: JoinModels = (session) => applyLocks({ ...session, ...courseEditorOf(session) });
