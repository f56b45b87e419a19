export declare function reachable(paths: Iterable<string>, read: (path: string) => string): Set<string>;
