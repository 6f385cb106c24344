import type { PageParts } from '../../kit/parts';
import type { LayoutParts } from '../layout/parts';
import type { ModeParts } from '../mode/parts';
import type { RunParts } from '../run/parts';
import type { TaskParts } from '../task/parts';
import type { VisitParts } from '../visit/parts';
import type { WorkParts } from '../work/model/parts';

/** The models of the session: what one works on, its run, and what is shown. */
export type SessionParts = PageParts & VisitParts & WorkParts & LayoutParts & RunParts & TaskParts & ModeParts;

/**
 * Joins a feature's models to the session's when a page is made. A feature has it in its `models.ts`, which draws
 * nothing.
 */
export type JoinModels = (session: SessionParts) => void;

/**
 * Begins to listen to the browser: keys, addresses, the page around. A feature has it in its `set-up.ts`; it is called in
 * the set-up of the app.
 */
export type SetUp = (session: SessionParts) => void;
