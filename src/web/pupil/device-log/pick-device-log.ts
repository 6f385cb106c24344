import type { TakesLogs } from './takes-logs';
import { pickFiles } from '../../kit/files/pick-files';
import { latePart } from '../../kit/late-part';

/** Asks for a file of readings; what reads it is fetched once there is one. */
export function pickDeviceLog(app: TakesLogs): void {
  pickFiles({ accept: '.htm,.html,.csv,.tsv,.txt,text/html,text/csv' }, (files) => {
    import('./open-device-log')
      .then(({ openChosenLogs }) => openChosenLogs(app, files))
      .catch(() => app.notices.show(latePart));
  });
}
