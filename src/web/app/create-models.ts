import { createSession } from '../session/models/create-session';
import type { RunEngine } from '../session/models/create-run';
import type { SessionParts } from '../session/models/session';
import type { HostWish } from '../session/visit/host-view';
import type { Opened } from '../session/work/model/keep-work';
import { featureModels } from './features/feature-models';
import { featurePages } from './features/feature-pages';

/** Makes the models of the session, and joins those of all features to them. */
export function createModels(opened: Opened, wish: HostWish, engine?: RunEngine): SessionParts {
  const session = createSession(opened, wish, featurePages, engine);
  for (const join of featureModels) join(session);
  return session;
}
