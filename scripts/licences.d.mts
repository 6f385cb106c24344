export function licencesOfApp(): Promise<string>;
