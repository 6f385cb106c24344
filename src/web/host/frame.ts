import type { Door, Outside } from '#embed/door';
import type { HostedPage } from './hosted-page';
import type { EmbeddedSimulator } from '#embed/simulator';
import { robotTypes } from '#robots/index';

import type { VisitParts } from '../visit/parts';
import { devices } from '../work/settings/devices';
import { appSimulator } from './app-simulator';
import { appVersion } from './app-version';
import type { OpenLate } from './late-door';
import { allowedOrigins, ORIGINS_META } from './origins';
import { openGate } from './transport';

/** Speaks with the page around this one, beginning with what it has said already. @returns ends it */
export function openFrame(app: HostedPage, early: readonly MessageEvent<unknown>[]): () => void {
  const simulator = appSimulator(app);
  const named = document.querySelector<HTMLMetaElement>(`meta[name="${ORIGINS_META}"]`)?.content ?? null;
  const gate = openGate({
    parent: window.parent,
    allowed: allowedOrigins(named, app.host.wish.origins),
    openOurs: (outside) => openOurs(simulator, outside),
    openUnasked: unaskedDialect(app, simulator),
    nowMs: () => performance.now(),
    onMissing: () => app.notices.show({ kind: 'error', key: 'notice.firmware' }),
  });
  const receive = (event: MessageEvent<unknown>): void => gate.receive(event);
  addEventListener('message', receive);
  for (const event of early) receive(event);
  return () => {
    removeEventListener('message', receive);
    gate.close();
  };
}

/** Another text after every load of the page; no secret. */
const PAGE_ID = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

async function openOurs(simulator: EmbeddedSimulator, outside: Outside): Promise<Door> {
  const { openParcoursDoor } = await import('#embed/parcours/door');
  return openParcoursDoor(simulator, outside, {
    app: appVersion,
    page: PAGE_ID,
    devices: devices.map(({ id }) => id),
    robots: robotTypes.map(({ id }) => id),
  });
}

function unaskedDialect(app: VisitParts, simulator: EmbeddedSimulator): OpenLate | null {
  const { dialect, settings } = app.host.wish;
  switch (dialect) {
    case null:
      return null;
    case 'microbit':
      return async (outside) => (await import('#embed/microbit/door')).openMicrobitDoor(simulator, outside, settings);
    case 'webtigerpython':
      return async (outside) => (await import('#embed/webtigerpython/door')).openWebTigerPythonDoor(simulator, outside);
    default:
      return dialect satisfies never;
  }
}
