import type { TakesLogs } from './takes-logs';
import { latePart } from '../../kit/late-part';

/** Asks for a file of readings; what reads it is fetched once there is one. */
export function pickDeviceLog(app: TakesLogs): void {
  const picker = document.createElement('input');
  picker.type = 'file';
  picker.accept = '.htm,.html,.csv,.tsv,.txt,text/html,text/csv';
  picker.addEventListener('change', () => {
    const files = [...(picker.files ?? [])];
    import('./open-device-log')
      .then(({ openChosenLogs }) => openChosenLogs(app, files))
      .catch(() => app.notices.show(latePart));
  });
  picker.click();
}
