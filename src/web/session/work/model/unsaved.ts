/** The reason why the work is stored nowhere: there is no room, or the browser forbids it. */
export type Unsaved = 'full' | 'forbidden';
