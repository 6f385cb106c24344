import type { JoinModels } from '../../session/models/session';
import { debugOf } from './parts';

/** The debugger follows the runs. */
export const join: JoinModels = (session) => void debugOf(session);
