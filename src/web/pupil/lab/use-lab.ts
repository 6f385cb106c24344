import { every, laneCount, serveThread } from '../../session/run/serve-thread';
import { lateModel } from '../../kit/state/late-models';
import type { RunParts } from '../../session/run/parts';
import { seedOf } from '../../session/work/hardware/hardware';
import { runSetup } from '../../session/work/run-setup';
import type { WorkParts } from '../../session/work/model/parts';
import { LabModel } from './model/lab-model';

/** Results that come within this time are shown together, in ms. Chosen: more often than ten times a second nobody sees. */
const TOGETHER_MS = 80;

/** The lab of this page: it stays while the page is open, also when it is out of sight. */
export const labOf = lateModel(
  (app: WorkParts & Pick<RunParts, 'run' | 'sensors'>) =>
    new LabModel({
      setup: () => ({
        setup: runSetup(app, (place) => app.sensors.startInputs(place)),
        usedSeed: app.settings.current.value.seed,
        idealSeed: seedOf({ ...app.settings.current.value, reality: 0 }),
      }),
      starter: async () => serveThread({ service: 'runs' }, await app.run.engine.firmware()),
      every,
      lanes: laneCount(),
      nowMs: () => performance.now(),
      later: (act) => void setTimeout(act, TOGETHER_MS),
    }),
);
