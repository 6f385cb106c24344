import type { Adapter, HostConnection } from '#embed/adapter';
import type { HostedPage } from './hosted-page';
import type { EmbeddedSimulator } from '#embed/simulator';
import { robotTypes } from '#robots/index';

import type { VisitParts } from '../../session/visit/parts';
import { courseIds } from '../../session/work/catalogue/course-ids';
import { devices } from '../../session/work/settings/devices';
import { appSimulator } from './app-simulator';
import { appVersion } from './app-version';
import type { OpenLate } from './late-adapter';
import { allowedOrigins, ORIGINS_META } from './origins';
import { openTransport } from './transport';
import { latePart } from '../../kit/late-part';

/** Speaks with the embedding page, beginning with the messages that it has already sent. @returns ends it */
export function openFrame(app: HostedPage, early: readonly MessageEvent<unknown>[]): () => void {
  const simulator = appSimulator(app);
  const named = document.querySelector<HTMLMetaElement>(`meta[name="${ORIGINS_META}"]`)?.content ?? null;
  const transport = openTransport({
    parent: window.parent,
    allowed: allowedOrigins(named, app.host.wish.origins),
    openOurs: (connection) => openOurs(simulator, connection),
    openUnasked: unaskedDialect(app, simulator),
    nowMs: () => performance.now(),
    onMissing: () => app.notices.show(latePart),
  });
  const receive = (event: MessageEvent<unknown>): void => transport.receive(event);
  addEventListener('message', receive);
  for (const event of early) receive(event);
  return () => {
    removeEventListener('message', receive);
    transport.close();
  };
}

/** A text that changes with every load of the page; not a secret. */
const PAGE_ID = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

async function openOurs(simulator: EmbeddedSimulator, connection: HostConnection): Promise<Adapter> {
  const { createParcoursAdapter } = await import('#embed/parcours/adapter');
  return createParcoursAdapter(simulator, connection, {
    app: appVersion,
    page: PAGE_ID,
    devices: devices.map(({ id }) => id),
    robots: robotTypes.map(({ id }) => id),
    courses: courseIds,
  });
}

function unaskedDialect(app: VisitParts, simulator: EmbeddedSimulator): OpenLate | null {
  const { dialect, settings } = app.host.wish;
  switch (dialect) {
    case null:
      return null;
    case 'microbit':
      return async (connection) =>
        (await import('#embed/microbit/adapter')).createMicrobitAdapter(simulator, connection, settings);
    case 'webtigerpython':
      return async (connection) =>
        (await import('#embed/webtigerpython/adapter')).createWebTigerPythonAdapter(simulator, connection);
    default:
      return dialect satisfies never;
  }
}
