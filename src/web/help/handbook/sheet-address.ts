/** The id of the sheet on data protection in the address of the handbook: `#handbook/data-protection`. */
export const SHEET = 'data-protection';
