const folders = import.meta.glob('../../../../courses/*/course.json', { query: '?raw' });

/** Ids of the ready courses: the names of their folders, without the courses themselves, which come late. */
export const courseIds: readonly string[] = Object.keys(folders).flatMap((path) => path.split('/').slice(-2, -1));
