//! The list of instruments: the factory's, those in the user's folder, and ways to bring more.

use super::choice::{closed, place, stepped};
use super::doors::Picked;
use super::param::Param;
use super::sheet::{News, Place, Sheet};
use super::theme::{Theme, small};
use super::ware::Ware;
use crate::mesher::Places;
use crate::notices::{Cure, Notice, Notices, Subject};
use crate::params::Controls;
use crate::shelf::{Librarian, Library, OWN, Said};
use crate::user_folder;
use egui::{
    Button, CursorIcon, FontId, OpenUrl, Popup, Rect, Response, RichText, ScrollArea, Ui, vec2,
};
use modes::MeshOrder;
use nice_plug::prelude::ParamSetter;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// Nobody cancels a dialog within this time.
const CANCEL: Duration = Duration::from_millis(300);
/// Least width of the list.
const LIST: f32 = 210.0;
/// Room that the list leaves below itself in the window.
const BELOW: f32 = 24.0;
/// What the list's last lines do.
const IMPORT: &str = "Takes banks, meshes, scales, keyboard maps and presets from anywhere, as dropping them on \
                      the window does";
const SHOW: &str = "Opens the folder; banks that are put there come into this list";
/// Folder of banks in the user's.
const FOLDER: &str = "Banks";

/// What the editor knows of instruments beyond the parameter.
pub struct Instruments {
    controls: Arc<Controls>,
    library: Arc<Library>,
    librarian: Option<Librarian>,
    sheet: Sheet,
    picked: Picked,
}

impl Instruments {
    pub(super) fn new(controls: &Arc<Controls>) -> Self {
        let folder = user_folder().map(|folder| folder.join(FOLDER));
        Self {
            controls: Arc::clone(controls),
            library: Arc::new(Library::new(folder)),
            librarian: None,
            sheet: Sheet::default(),
            picked: Picked::default(),
        }
    }

    /// The user's folder of banks.
    #[must_use]
    pub fn library(&self) -> &Arc<Library> {
        &self.library
    }

    /// Another folder of banks; nobody watches it yet.
    pub fn set_library(&mut self, library: Library) {
        self.librarian = None;
        self.library = Arc::new(library);
    }

    /// Has the folder watched, and what is asked for loaded, until this is dropped; `news` is told when there
    /// is something new to draw.
    pub(super) fn watch(&mut self, news: impl Fn() + Send + Sync + 'static) {
        let news: News = Arc::new(news);
        self.sheet.news = Arc::clone(&news);
        let notices = Arc::clone(self.notices());
        let say = move |said: &Said<'_>| notices.post(told(said));
        let library = Arc::clone(&self.library);
        let shelf = Arc::clone(self.controls.shelf());
        self.librarian = Some(Librarian::hire(library, shelf, say, move || news()));
    }

    /// Takes a file: a bank is loaded, a mesh comes onto the sheet.
    pub fn open(&self, path: PathBuf) {
        if Ware::of(&path) == Some(Ware::Mesh) {
            self.shape(vec![path]);
        } else {
            self.library.ask(path);
        }
    }

    /// Takes meshes onto a new sheet: several become a kit.
    pub(super) fn shape(&self, paths: Vec<PathBuf>) {
        self.sheet.chosen().put((paths, Place::New));
    }

    /// Has what plays as a preview built in full quality, on the sheet.
    pub(super) fn finish(&self, order: &MeshOrder) {
        self.sheet.finish(order.clone());
    }

    /// Files that were chosen in the dialog.
    pub(super) fn picked(&self) -> &Picked {
        &self.picked
    }

    /// Takes a mesh onto the sheet that is open, as a further body.
    pub fn add(&self, path: PathBuf) {
        self.sheet.chosen().put((vec![path], Place::Further));
    }

    /// Draws the sheet of a mesh, if one is open.
    pub(super) fn show_sheet(&mut self, ui: &Ui, theme: &Theme) {
        let places = Places {
            library: Arc::clone(&self.library),
            shelf: Arc::clone(self.controls.shelf()),
            notices: Arc::clone(self.controls.notices()),
        };
        if self.sheet.show(ui, &places, theme) {
            self.import(Place::Further);
        }
    }

    pub(super) fn notices(&self) -> &Arc<Notices> {
        self.controls.notices()
    }

    /// Plays a bank that has come.
    pub(super) fn arrive(&self, param: &Param, setter: &ParamSetter<'_>) {
        if self.library.arrived() {
            self.notices().clear(Subject::File);
            self.notices().clear(Subject::Bank);
            // Even if it stood there before: that tells the host that the song has changed.
            param.put(setter, param.place(OWN as f32));
        }
    }

    /// What the user should know first.
    pub(super) fn news(&self) -> Option<Notice> {
        self.notices().first().or_else(|| {
            let missing = self.controls.body.index() == OWN && self.controls.shelf().own().is_none();
            missing.then(|| Notice {
                subject: Subject::File,
                text: "There is no instrument of your own yet: put banks into the folder, and choose one in \
                       the list above. Wind chimes play meanwhile."
                    .to_owned(),
                cure: Some(Cure::Load(String::new())),
            })
        })
    }

    /// The song is content with what plays.
    pub(super) fn stay(&self) {
        self.controls.stay();
    }

    /// Shows the folder in the system's own window.
    pub(super) fn show_folder(&self, ui: &Ui) {
        if let Some(folder) = self.library.folder() {
            // A folder that cannot be made is not shown either, which the system says.
            let _ = std::fs::create_dir_all(folder);
            ui.ctx().open_url(OpenUrl::new_tab(folder.display()));
        }
    }

    /// Asks the system for files, on a thread of its own; whatever comes is taken as if it were dropped, but for
    /// meshes that are to be further bodies on the sheet.
    fn import(&self, place: Place) {
        let ends = Ware::ALL.map(|(_, end)| end);
        let dialog = rfd::AsyncFileDialog::new()
            .set_title("Files for Idiophone")
            .add_filter("Banks, meshes, scales, keyboard maps, presets", &ends);
        // Made here, because some systems want that on the window's thread.
        let picked = dialog.pick_files();
        let notices = Arc::clone(self.notices());
        let (waiting, chosen) = (self.picked.clone(), self.sheet.chosen());
        let news = Arc::clone(&self.sheet.news);
        let asked = Instant::now();
        // Without a thread to be had, there is still the folder.
        let _ = thread::Builder::new()
            .name("idiophone dialog".to_owned())
            .spawn(move || match pollster::block_on(picked) {
                Some(files) => {
                    let paths = files.iter().map(|file| file.path().to_path_buf());
                    let further =
                        |path: &PathBuf| place == Place::Further && Ware::of(path) == Some(Ware::Mesh);
                    let (meshes, others): (Vec<_>, Vec<_>) = paths.partition(further);
                    if !meshes.is_empty() {
                        chosen.put((meshes, place));
                    }
                    waiting.put(others);
                    news();
                }
                None if asked.elapsed() < CANCEL => notices.post(Notice {
                    subject: Subject::File,
                    text: "This desktop has no file dialog for plug-ins (xdg-desktop-portal): drop files on the \
                           window, or put banks and meshes into the folder, and they are in the list."
                        .to_owned(),
                    cure: Some(Cure::Load(String::new())),
                }),
                None => {}
            });
    }

    /// The box at `rect`: click to open the list, arrows and wheel to go through the factory's.
    pub(super) fn show(
        &self,
        ui: &Ui,
        rect: Rect,
        param: &Param,
        theme: &Theme,
        font: FontId,
        setter: &ParamSetter<'_>,
    ) -> Response {
        let steps = param.steps().unwrap_or(1);
        let own = self.controls.shelf().own();
        let text = match &own {
            Some(own) if self.controls.body.index() == OWN => own.title(),
            _ => param.text(),
        };
        let response = closed(ui, rect, (param, &text), theme, font, setter);
        let mut wanted = None;
        let wide = rect.width().max(LIST);
        Popup::menu(&response).width(wide).show(|ui| {
            ui.set_min_width(wide);
            let tall = ui.ctx().content_rect().bottom() - rect.bottom() - BELOW;
            // As tall as the window lets it be, which is more than menus are of themselves.
            let scroll = ScrollArea::vertical()
                .max_height(tall)
                .min_scrolled_height(tall);
            scroll.show(ui, |ui| {
                let list = List {
                    param,
                    theme,
                    wide: wide - 24.0,
                };
                wanted = list.show(ui, self);
            });
        });
        let moved = stepped(ui, &response);
        if moved != 0.0 {
            param.put(setter, param.value() + moved / steps as f32);
        }
        match wanted {
            Some(Wanted::Number(index)) => param.put(setter, place(index, steps)),
            Some(Wanted::File(path)) => self.open(path),
            Some(Wanted::Import) => self.import(Place::New),
            Some(Wanted::Folder) => self.show_folder(ui),
            None => {}
        }
        response
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_text(param.spec.tooltip)
    }
}

/// What a librarian says, for people.
fn told(said: &Said<'_>) -> Notice {
    let (text, cure) = match said {
        Said::Refused(error) => (error.to_string(), None),
        Said::Renewed(card) => {
            let text = format!(
                "\"{}\" has been built anew in your folder; the song has it as it was.",
                card.title
            );
            (text, Some(Cure::Load(card.name.clone())))
        }
    };
    Notice {
        subject: Subject::File,
        text,
        cure,
    }
}

/// What is chosen from the list.
enum Wanted {
    Number(usize),
    File(PathBuf),
    Import,
    Folder,
}

/// The open list.
struct List<'a> {
    param: &'a Param,
    theme: &'a Theme,
    wide: f32,
}

impl List<'_> {
    fn show(&self, ui: &mut Ui, of: &Instruments) -> Option<Wanted> {
        let mut wanted = None;
        let here = of.controls.body.index();
        for index in 0..OWN {
            let name = self.param.text_at(self.param.place(index as f32));
            if self.line(ui, here == index, name, "") {
                wanted = Some(Wanted::Number(index));
            }
        }
        self.heading(ui, "Your own");
        let own = of.controls.shelf().own();
        if let Some(own) = &own
            && self.line(
                ui,
                here == OWN,
                format!("{} (in this song)", own.title()),
                "",
            )
        {
            wanted = Some(Wanted::Number(OWN));
        }
        for entry in &*of.library.entries() {
            match &entry.card {
                Ok(_) => {
                    let file = entry.path.display().to_string();
                    if self.line(ui, false, entry.title(), &file) {
                        wanted = Some(Wanted::File(entry.path.clone()));
                    }
                }
                Err(reason) => {
                    let name = RichText::new(entry.title()).color(self.theme.alarm);
                    ui.add_enabled(false, Button::new(name).frame(false))
                        .on_disabled_hover_text(reason);
                }
            }
        }
        for path in &*of.library.meshes() {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            let file = path.display().to_string();
            if self.line(ui, false, format!("{stem} (mesh)"), &file) {
                wanted = Some(Wanted::File(path.clone()));
            }
        }
        ui.separator();
        if self.line(ui, false, "Import…".to_owned(), IMPORT) {
            wanted = Some(Wanted::Import);
        }
        if of.library.folder().is_some() && self.line(ui, false, "Show the folder".to_owned(), SHOW)
        {
            wanted = Some(Wanted::Folder);
        }
        wanted
    }

    fn heading(&self, ui: &mut Ui, text: &str) {
        ui.separator();
        ui.label(RichText::new(text).font(small()).color(self.theme.quiet));
    }

    /// A line to click, with more to say of it; whether it was.
    fn line(&self, ui: &mut Ui, here: bool, text: String, more: &str) -> bool {
        let line = Button::selectable(here, text).min_size(vec2(self.wide, 22.0));
        let mut response = ui.add(line);
        if !more.is_empty() {
            response = response.on_hover_text(more);
        }
        let clicked = response.clicked();
        if clicked {
            ui.close();
        }
        clicked
    }
}
