import { courseEditorOf } from '../../course/editor/state/parts';
import type { JoinModels } from '../../session/models/session';
import { keepTask } from './keep-task';

/** The locks of a task hold while it is open. */
export const join: JoinModels = (session) => keepTask({ ...session, ...courseEditorOf(session) });
