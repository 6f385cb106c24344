import type { HostView } from './host-view';
import { part } from '../../kit/part';

/** The wishes of the address and of the page around this one. */
export interface VisitParts {
  readonly host: HostView;
}

export const [provideVisit, useVisit] = part<VisitParts>('visit');
