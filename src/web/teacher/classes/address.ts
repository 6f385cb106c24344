/** The address of the page with the classes. */
export const CLASSES = 'classes';
