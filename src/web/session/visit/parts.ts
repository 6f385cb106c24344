import type { HostView } from './host-view';
import { part } from '../../kit/part';

/** What the address and the page around this one ask for. */
export interface VisitParts {
  readonly host: HostView;
}

export const [provideVisit, useVisit] = part<VisitParts>('visit');
