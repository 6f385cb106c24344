import { filesOfDevice } from '#project/devices';

import type { RunParts } from '../run/parts';
import type { WorkParts } from './model/parts';

type Parts = Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>;

/** True if any program has been written on since the run began. */
export function isChanged(parts: Parts): boolean {
  const { devices = [] } = parts.run.recording.value.setup ?? {};
  const { project } = parts.work.work.value;
  return devices.some(({ files }, device) => {
    const now = filesOfDevice(project, device);
    return now.length !== Object.keys(files).length || now.some(({ name, text }) => files[name] !== text);
  });
}
