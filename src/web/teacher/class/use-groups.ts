import { projectOfTask } from '#check/task/write-task';
import { watch } from 'vue';

import { lateModel } from '../../kit/state/late-models';
import { every, laneCount, serveThread } from '../../session/run/serve-thread';
import { compileFirmware } from '../../session/run/worker/firmware';
import { classOf } from './use-class';
import { GroupsModel } from './groups/groups-model';

/** The groups of the class that is checked on this page. They are found from the first request on, while hand-ins arrive. */
export const groupsOfClass = lateModel((app) => {
  const model = classOf(app);
  const groups = new GroupsModel(model, {
    looker: async (task) => serveThread({ service: 'facts', task: projectOfTask(task) }, await compileFirmware()),
    hinter: async (task) => serveThread({ service: 'group-hint', task: projectOfTask(task) }, await compileFirmware()),
    every,
    lanes: laneCount(),
  });
  watch(model.rows, () => void groups.look(), { immediate: true });
  return groups;
});
