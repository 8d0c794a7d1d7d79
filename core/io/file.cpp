// Whole files in and out of memory, through POSIX calls: the standard streams tell neither why something
// failed nor whether the bytes have reached the disk.
#include "core/io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace archetype {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

// Makes a new file beside `path`, with the permissions that the user's umask gives; says its name. Negative
// with errno set if it cannot.
int create_beside(const std::filesystem::path& path, std::string& name) {
  for (int attempt = 0;; ++attempt) {
    name = path.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
}

// Everything that can fail between making the temporary file and its having the final name.
void write_and_rename(int fd, const std::string& temporary, const std::filesystem::path& path,
                      std::string_view content) {
  const auto check = [&](bool done, const char* what) {
    if (!done) throw FileError(path, std::string("cannot be written (") + what + ": " + reason(errno) + ")");
  };
  while (!content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    check(written >= 0, "write");
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  struct stat old {};
  // Keeps a file's permissions; that some file systems have none is no reason to fail.
  if (::stat(path.c_str(), &old) == 0 && ::fchmod(fd, old.st_mode & 0777U) != 0) errno = 0;
  check(::fsync(fd) == 0, "fsync");
  check(::rename(temporary.c_str(), path.c_str()) == 0, "rename");
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) throw FileError(path, "cannot be opened (" + reason(errno) + ")");
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) throw FileError(path, "cannot be read (" + reason(errno) + ")");
  if (S_ISDIR(info.st_mode)) throw FileError(path, "is a folder, not a file");
  if (!S_ISREG(info.st_mode)) throw FileError(path, "is a pipe or device, not a file");
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size > max_bytes) {
    throw FileError(
        path, "holds " + std::to_string(size) + " bytes; at most " + std::to_string(max_bytes) + " are read");
  }
  std::string content(size, '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::read(file.get(), content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw FileError(path, "cannot be read (" + reason(errno) + ")");
    if (count == 0) throw FileError(path, "became shorter while it was read; try again");
    done += static_cast<std::size_t>(count);
  }
  return content;
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
  std::string temporary;
  const Descriptor file(create_beside(path, temporary));
  if (file.get() < 0) throw FileError(path, "cannot be written (" + reason(errno) + ")");
  try {
    write_and_rename(file.get(), temporary, path, content);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  // The rename itself reaches the disk with its folder. A failure here loses nothing that was promised.
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY));
  if (directory.get() >= 0) ::fsync(directory.get());
}

}  // namespace archetype
