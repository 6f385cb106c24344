import type { JoinModels } from '../../session/models/session';
import { emptyConsole, followRuns } from './follow-runs';
import { consoleOf } from './parts';

/** The console tells of the runs. */
export const join: JoinModels = (session) => {
  const app = { ...session, ...consoleOf(session) };
  followRuns(app);
  emptyConsole(app);
};
