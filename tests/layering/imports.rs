//! Which file uses which: imports and paths in code, resolved to the file that defines what they
//! name.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use crate::words::words;

/// `motes`, `pairs`, `law`, ...
type Names = Vec<String>;

/// What is written in a module: `use path as name`, `*` for all of it; or a path in code, without a
/// name.
#[derive(Debug)]
struct Mention {
    /// The module in which it is written.
    module: Names,
    path: Names,
    name: Option<String>,
    /// Whether it hands the name on and the file itself does not use it.
    is_export: bool,
}

/// A source file.
#[derive(Debug, Default)]
struct Source {
    module: Names,
    items: BTreeSet<String>,
    mentions: Vec<Mention>,
}

/// The sources of a crate.
pub struct Crate {
    /// By path from the root of the crate.
    sources: BTreeMap<PathBuf, Source>,
    /// The file of each module, inline ones too.
    modules: BTreeMap<Names, PathBuf>,
    /// The file of each exported macro.
    macros: BTreeMap<String, PathBuf>,
}

impl Crate {
    /// Reads all sources below a folder but those of tests.
    pub fn read(root: &Path) -> Self {
        let mut all = Self {
            sources: BTreeMap::new(),
            modules: BTreeMap::new(),
            macros: BTreeMap::new(),
        };
        for file in sources(root) {
            let relative = file.strip_prefix(root).unwrap().to_owned();
            let module = module_of(&relative);
            if module.iter().any(|name| name == "tests") {
                continue;
            }
            let text = std::fs::read_to_string(&file).unwrap();
            all.modules.insert(module.clone(), relative.clone());
            let source = all.parse(&relative, module, &words(&text));
            all.sources.insert(relative, source);
        }
        all
    }

    /// The files that a file uses, for every file.
    pub fn uses(&self) -> BTreeMap<&Path, BTreeSet<&Path>> {
        let uses = |(file, source): (&'_ PathBuf, &'_ Source)| -> BTreeSet<&Path> {
            let used = source.mentions.iter().filter_map(|mention| {
                let target = self.resolve(&mention.module, &mention.path, 0)?;
                let is_below = self.sources[target].module.starts_with(&source.module);
                let is_import = target != file && !(mention.is_export && is_below);
                is_import.then_some(target)
            });
            used.collect()
        };
        let files = self.sources.iter();
        files.map(|row| (row.0.as_path(), uses(row))).collect()
    }

    /// The file that defines what a path names; `None` for other crates and for modules.
    fn resolve(&self, module: &Names, path: &[String], depth: usize) -> Option<&Path> {
        // A name that is bound to itself, as in `use x::x`.
        if depth > 16 {
            return None;
        }
        let (first, mut rest) = path.split_first()?;
        let mut at = match first.as_str() {
            "crate" => Names::new(),
            "self" => module.clone(),
            "super" => {
                let mut at = module[..module.len().checked_sub(1)?].to_vec();
                while rest.first().is_some_and(|name| name == "super") {
                    at.pop()?;
                    rest = &rest[1..];
                }
                at
            }
            _ if self.modules.contains_key(&below(module, first)) => below(module, first),
            _ => {
                // What `use` has bound here, with what follows it.
                let bound = self.binding(module, first)?;
                let path: Names = bound.path.iter().chain(rest).cloned().collect();
                return (bound.path != path || depth == 0)
                    .then(|| self.resolve(module, &path, depth + 1))?;
            }
        };
        while let Some((name, more)) = rest.split_first() {
            let next = below(&at, name);
            if !self.modules.contains_key(&next) {
                return self.item(&at, name, more, depth);
            }
            (at, rest) = (next, more);
        }
        None
    }

    /// The file that defines a name of a module, which may have it from elsewhere.
    fn item(&self, module: &Names, name: &str, more: &[String], depth: usize) -> Option<&Path> {
        let file = self.modules[module].as_path();
        let source = self.sources.get(file)?;
        if source.items.contains(name) {
            return Some(file);
        }
        if let Some(bound) = self.binding(module, name) {
            let path: Names = bound.path.iter().chain(more).cloned().collect();
            return self.resolve(module, &path, depth + 1);
        }
        if let (true, Some(file)) = (module.is_empty(), self.macros.get(name)) {
            return Some(file);
        }
        Some(file)
    }

    fn binding(&self, module: &Names, name: &str) -> Option<&Mention> {
        let source = self.sources.get(self.modules.get(module)?)?;
        let mut mentions = source.mentions.iter();
        mentions.find(|mention| mention.name.as_deref() == Some(name) && mention.module == *module)
    }

    /// What a file defines and mentions.
    fn parse(&mut self, file: &Path, module: Names, words: &[String]) -> Source {
        let mut source = Source {
            module: module.clone(),
            ..Source::default()
        };
        let word = |i: usize| words.get(i).map_or("", String::as_str);
        // Inline modules around the place, with the depth of their braces.
        let (mut scope, mut inline, mut depth) = (module, Vec::new(), 0);
        let mut uses = vec![false; words.len()];
        let mut is_exported = false;
        let mut i = 0;
        while i < words.len() {
            let next = word(i + 1);
            match word(i) {
                "{" => depth += 1,
                "}" => {
                    depth -= 1;
                    if inline.last() == Some(&depth) {
                        inline.pop();
                        scope.pop();
                    }
                }
                "macro_export" => is_exported = true,
                "macro_rules" if next == "!" => {
                    source.items.insert(word(i + 2).to_owned());
                    if std::mem::take(&mut is_exported) {
                        self.macros.insert(word(i + 2).to_owned(), file.to_owned());
                    }
                }
                "mod" if word(i + 2) == "{" => {
                    scope.push(next.to_owned());
                    inline.push(depth);
                    self.modules.insert(scope.clone(), file.to_owned());
                }
                "fn" | "struct" | "enum" | "trait" | "type" | "const" | "static" => {
                    source.items.insert(next.to_owned());
                }
                "use" if i == 0 || word(i - 1) != "+" && next != "<" => {
                    let is_export = i > 0 && ["pub", ")"].contains(&word(i - 1));
                    let mut end = i + 1;
                    tree(words, &mut end, &Names::new(), &mut |path, name| {
                        source.mentions.push(Mention {
                            module: scope.clone(),
                            path,
                            name: Some(name),
                            is_export,
                        });
                    });
                    uses[i..end.min(words.len())].fill(true);
                    i = end;
                    continue;
                }
                name if next == "::" && is_name(name) && word(i.wrapping_sub(1)) != "::" => {
                    let mut path = vec![name.to_owned()];
                    while word(i + 1) == "::" && is_name(word(i + 2)) {
                        path.push(word(i + 2).to_owned());
                        i += 2;
                    }
                    source.mentions.push(Mention {
                        module: scope.clone(),
                        path,
                        name: None,
                        is_export: false,
                    });
                }
                _ => {}
            }
            i += 1;
        }
        // An export that the code around it uses as well is an import.
        let in_code = |name: &String| {
            let is_use =
                |i: usize| !uses[i] && words[i] == *name && word(i.wrapping_sub(1)) != "mod";
            (0..words.len()).any(is_use)
        };
        for mention in &mut source.mentions {
            mention.is_export &= !mention.name.as_ref().is_some_and(in_code);
        }
        source
    }
}

/// Reads one branch of the tree of a `use` from `at` on and gives out its paths.
fn tree(words: &[String], at: &mut usize, before: &Names, out: &mut impl FnMut(Names, String)) {
    let mut path = before.clone();
    loop {
        let word = words.get(*at).map_or(";", String::as_str);
        *at += 1;
        match word {
            "::" => {}
            "{" => {
                while words.get(*at).is_some_and(|word| word != "}") {
                    tree(words, at, &path, out);
                    if words.get(*at).is_some_and(|word| word == ",") {
                        *at += 1;
                    }
                }
                *at += 1;
                return;
            }
            "," | "}" | ";" => {
                *at -= 1;
                let name = path.last().cloned().unwrap_or_default();
                if path.len() > before.len() || before.is_empty() {
                    out(path, name);
                }
                return;
            }
            "as" => {
                let name = words.get(*at).cloned().unwrap_or_default();
                *at += 1;
                out(path, name);
                return;
            }
            "self" if !before.is_empty() => {
                out(path.clone(), path.last().cloned().unwrap_or_default());
                return;
            }
            _ => path.push(word.to_owned()),
        }
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

fn below(module: &Names, name: &str) -> Names {
    module.iter().cloned().chain([name.to_owned()]).collect()
}

/// The module of a file: `pairs/mod.rs` and `pairs.rs` are `pairs`, `lib.rs` and `main.rs` the root.
fn module_of(file: &Path) -> Names {
    let names = file.with_extension("");
    let mut module: Names = names
        .iter()
        .map(|name| name.to_str().unwrap().to_owned())
        .collect();
    if module.last().is_some_and(|name| name == "mod") {
        module.pop();
    }
    if module == ["lib"] {
        module.pop();
    }
    module
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}
